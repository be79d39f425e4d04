#include "tools/make_board/board_pdf.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <vector>

#include "calibration/board_drawing.h"

namespace markerless_mocap {
namespace {

constexpr double kPointsPerMm = 72.0 / 25.4;
constexpr double kMargin = 8.0, kRulerHeight = 16.0;  // mm

template <class... Args>
std::string text(const char* format, Args... args) {
  char buffer[400];
  std::snprintf(buffer, sizeof buffer, format, args...);
  return buffer;
}

struct NamedPage {
  const char* name;
  double width, height;  ///< mm, lying
};

constexpr NamedPage kPages[] = {{"A4", 297, 210}, {"A3", 420, 297},  {"A2", 594, 420},
                                {"A1", 841, 594}, {"A0", 1189, 841}, {"letter", 279.4, 215.9}};

/// Around the pattern, for detectors to see its edge, mm.
double quietZone(const Board& board) {
  return std::min(kMargin, 0.3 * 1e3 * board.options().square);
}

Eigen::Vector2d neededSize(const Board& board) {
  const double around = 2 * kMargin;
  return 1e3 * board.size() + Eigen::Vector2d(around, around + kRulerHeight);
}

bool fits(const Board& board, const Page& page) {
  const Eigen::Vector2d needed = neededSize(board);
  return needed.x() <= page.width && needed.y() <= page.height;
}

std::string rectangle(double x, double y, double width, double height) {
  return text("%.4f %.4f %.4f %.4f re\n", x * kPointsPerMm, y * kPointsPerMm, width * kPointsPerMm,
              height * kPointsPerMm);
}

std::string words(double x, double y, double points, const std::string& content) {
  return text("BT /F1 %.1f Tf %.4f %.4f Td (", points, x * kPointsPerMm, y * kPointsPerMm) +
         content + ") Tj ET\n";
}

/// Millimetre marks and numbers at whole centimetres.
std::string ruler(double x, double y, int centimetres) {
  std::string out;
  for (int mm = 0; mm <= 10 * centimetres; ++mm) {
    const double tall = mm % 10 == 0 ? 4.0 : mm % 5 == 0 ? 3.0 : 2.0;
    out += rectangle(x + mm - 0.05, y, 0.1, tall);
  }
  out += rectangle(x, y, 10.0 * centimetres, 0.15) + "f\n";
  for (int cm = 0; cm <= centimetres; ++cm)
    out += words(x + 10.0 * cm - 1.0, y + 4.6, 6, std::to_string(cm));
  return out;
}

std::string description(const Board& board) {
  const BoardOptions& o = board.options();
  std::string out =
      text("%s %d x %d, square %.2f mm", o.kind.c_str(), o.columns, o.rows, 1e3 * o.square);
  if (o.kind != "chessboard")
    out +=
        text(", marker %.2f mm, %s from %d", 1e3 * o.marker, o.dictionary.c_str(), o.first_marker);
  return out;
}

std::string content(const Board& board, const Page& page) {
  const Eigen::Vector2d size = 1e3 * board.size();
  const double left = (page.width - size.x()) / 2;
  const double bottom = kRulerHeight + (page.height - kRulerHeight - size.y()) / 2;
  const double white = quietZone(board);
  std::string out = "0 g\n";
  if (board.options().inverted)
    out += rectangle(left - white, bottom - white, size.x() + 2 * white, size.y() + 2 * white) +
           "f\n1 g\n";
  for (const BoardBox& box : printedBoxes(board)) {
    const Eigen::Vector2d corner = 1e3 * box.lower_left, wide = 1e3 * box.upper_right - corner;
    out += rectangle(left + corner.x(), bottom + corner.y(), wide.x(), wide.y());
  }
  const int centimetres = int(std::clamp((page.width - 2 * kMargin) / 10.0, 5.0, 20.0));
  out += "f\n0 g\n" + ruler(kMargin, kMargin - 2, centimetres);
  out += words(
      kMargin, kMargin + 6, 7,
      description(board) + text(". Print at 100 %%: the ruler is %d mm long.", 10 * centimetres));
  return out;
}

}  // namespace

Page pageFor(const Board& board, const std::string& name) {
  for (const NamedPage& page : kPages) {
    if (name != page.name) continue;
    const Page lying{page.width, page.height}, standing{page.height, page.width};
    if (fits(board, lying)) return lying;
    if (fits(board, standing)) return standing;
    const Eigen::Vector2d needed = neededSize(board);
    throw std::invalid_argument(
        text("the board needs %.0f x %.0f mm with its margin and ruler, %s is %.0f x %.0f mm",
             needed.x(), needed.y(), page.name, page.width, page.height));
  }
  Page own;
  char rest = 0;
  if (std::sscanf(name.c_str(), "%lfx%lf%c", &own.width, &own.height, &rest) != 2)
    throw std::invalid_argument("there is no page " + name +
                                ", allowed are A4, A3, A2, A1, A0, letter and WIDTHxHEIGHT in mm");
  if (!fits(board, own)) {
    const Eigen::Vector2d needed = neededSize(board);
    throw std::invalid_argument(
        text("the board needs %.0f x %.0f mm with its margin and ruler, the page is %g x %g mm",
             needed.x(), needed.y(), own.width, own.height));
  }
  return own;
}

std::string boardPdf(const Board& board, const Page& page) {
  const std::string stream = content(board, page);
  const std::vector<std::string> objects = {
      // Viewers and printers that heed it do not scale the page.
      "<< /Type /Catalog /Pages 2 0 R /ViewerPreferences << /PrintScaling /None >> >>",
      "<< /Type /Pages /Kids [3 0 R] /Count 1 >>",
      text("<< /Type /Page /Parent 2 0 R /MediaBox [0 0 %.4f %.4f] /Contents 4 0 R /Resources << "
           "/Font << /F1 5 0 R >> >> >>",
           page.width * kPointsPerMm, page.height * kPointsPerMm),
      "<< /Length " + std::to_string(stream.size()) + " >>\nstream\n" + stream + "endstream",
      "<< /Type /Font /Subtype /Type1 /BaseFont /Helvetica >>"};
  std::string pdf = "%PDF-1.4\n", table;
  for (size_t i = 0; i < objects.size(); ++i) {
    table += text("%010zu 00000 n \n", pdf.size());
    pdf += std::to_string(i + 1) + " 0 obj\n" + objects[i] + "\nendobj\n";
  }
  const size_t start = pdf.size();
  return pdf + text("xref\n0 %zu\n0000000000 65535 f \n", objects.size() + 1) + table +
         text("trailer\n<< /Size %zu /Root 1 0 R >>\nstartxref\n%zu\n%%%%EOF\n", objects.size() + 1,
              start);
}

}  // namespace markerless_mocap
