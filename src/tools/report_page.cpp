#include "tools/report_page.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iomanip>
#include <opencv2/imgcodecs.hpp>
#include <sstream>

namespace markerless_mocap {
namespace {

constexpr double kWidth = 900.0, kPlotHeight = 140.0, kBandHeight = 24.0;  // SVG units

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) {
    if (c == '<')
      out += "&lt;";
    else if (c == '&')
      out += "&amp;";
    else if (c == '"')
      out += "&quot;";
    else
      out += c;
  }
  return out;
}

std::string base64(const std::vector<uint8_t>& bytes) {
  static const char* kDigits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const size_t left = std::min<size_t>(3, bytes.size() - i);
    uint32_t three = bytes[i] << 16;
    if (left > 1) three |= bytes[i + 1] << 8;
    if (left > 2) three |= bytes[i + 2];
    for (size_t k = 0; k < 4; ++k) out += k <= left ? kDigits[three >> (18 - 6 * k) & 63] : '=';
  }
  return out;
}

const char* colorOf(PoseStatus status) {
  switch (status) {
    case PoseStatus::kTracked:
      return "#2a9d5c";
    case PoseStatus::kReinitialized:
      return "#e0a020";
    case PoseStatus::kLost:
      break;
  }
  return "#c0392b";
}

std::string seconds(int64_t stamp_ns) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(3) << stamp_ns * 1e-9 << " s";
  return text.str();
}

/// A row's place on the axis of time.
double leftOf(size_t row, size_t rows) {
  return kWidth * double(row) / double(rows);
}

std::string statusBand(const std::vector<ReportRow>& rows) {
  std::ostringstream svg;
  svg << "<svg viewBox=\"0 0 " << kWidth << ' ' << kBandHeight << "\">";
  for (size_t i = 0; i < rows.size(); ++i)
    svg << "<rect x=\"" << leftOf(i, rows.size()) << "\" width=\"" << kWidth / rows.size() + 0.2
        << "\" height=\"" << kBandHeight << "\" fill=\"" << colorOf(rows[i].status) << "\"><title>"
        << seconds(rows[i].stamp_ns) << ": " << toString(rows[i].status) << ' '
        << escaped(rows[i].reason) << "</title></rect>";
  svg << "</svg>\n";
  return svg.str();
}

using Figure = std::function<double(const ReportRow&)>;

/// A line over time from 0 to `top`; broken where there is no figure.
std::string plot(const std::vector<ReportRow>& rows, const Figure& figure, double top) {
  std::ostringstream svg;
  svg << "<svg viewBox=\"0 0 " << kWidth << ' ' << kPlotHeight << "\" class=\"plot\">";
  for (const double share : {0.25, 0.5, 0.75})
    svg << "<path d=\"M0 " << share * kPlotHeight << "H" << kWidth
        << "\" stroke=\"#ddd\"/><text x=\"2\" y=\"" << share * kPlotHeight - 3 << "\">"
        << (1.0 - share) * top << "</text>";
  svg << "<path fill=\"none\" stroke=\"#1f5fa8\" stroke-width=\"1.5\" d=\"";
  bool drawing = false;
  for (size_t i = 0; i < rows.size(); ++i) {
    const double value = figure(rows[i]);
    if (std::isfinite(value)) {
      const double y = kPlotHeight * (1.0 - std::min(value / top, 1.0));
      svg << (drawing ? 'L' : 'M') << leftOf(i, rows.size()) << ' ' << y;
      // A short step makes a single instant visible.
      svg << "h" << kWidth / rows.size();
    }
    drawing = std::isfinite(value);
  }
  svg << "\"/></svg>\n";
  return svg.str();
}

std::string counts(const std::vector<ReportRow>& rows) {
  std::ostringstream text;
  const auto count = [&](PoseStatus status) {
    return std::count_if(rows.begin(), rows.end(),
                         [&](const ReportRow& row) { return row.status == status; });
  };
  text << rows.size() << " instants: " << count(PoseStatus::kTracked) << " tracked, "
       << count(PoseStatus::kReinitialized) << " reinitialized, " << count(PoseStatus::kLost)
       << " lost";
  return text.str();
}

std::string cameraTable(const ReportContent& content) {
  std::ostringstream table;
  table << "<table><tr><th>camera</th><th>mean IoU</th></tr>" << std::fixed << std::setprecision(3);
  for (size_t i = 0; i < content.cameras.size(); ++i) {
    table << "<tr><td>" << escaped(content.cameras[i]) << "</td><td>";
    if (std::isfinite(content.iou_of_camera[i])) table << content.iou_of_camera[i];
    table << "</td></tr>";
  }
  table << "</table>\n";
  return table.str();
}

std::string pictureTag(const ReportPicture& picture) {
  std::vector<uint8_t> jpeg;
  cv::imencode(".jpg", picture.image, jpeg, {cv::IMWRITE_JPEG_QUALITY, 80});
  return "<figure><img src=\"data:image/jpeg;base64," + base64(jpeg) + "\"><figcaption>" +
         escaped(picture.caption) + "</figcaption></figure>\n";
}

constexpr const char* kStyle =
    "body{font:15px sans-serif;max-width:960px;margin:2em auto;color:#222}"
    "svg{width:100%;display:block}.plot{border:1px solid #bbb}text{font-size:11px;fill:#888}"
    "td,th{padding:2px 12px;text-align:left}img{max-width:100%}figure{margin:1em 0}";

}  // namespace

std::string reportPage(const ReportContent& content) {
  const std::string title = escaped(content.title);
  std::string page = "<!DOCTYPE html><html><head><meta charset=\"utf-8\"><title>" + title +
                     "</title><style>" + kStyle + "</style></head><body>\n<h1>" + title +
                     "</h1>\n<p>" + counts(content.rows) + "</p>\n";
  page += "<h2>Status</h2><p>green tracked, amber reinitialized, red lost</p>\n" +
          statusBand(content.rows);
  page += "<h2>Overlap of body and masks</h2><p>mean intersection over union of the views</p>\n" +
          plot(
              content.rows, [](const ReportRow& row) { return row.mean_iou; }, 1.0);
  page += "<h2>Skeleton error</h2><p>mean distance of part curves to the body, mm</p>\n" +
          plot(
              content.rows, [](const ReportRow& row) { return 1e3 * row.skeleton_error_m; }, 200);
  page += cameraTable(content) + "<h2>Pictures</h2><p>filled: body; outline: mask</p>\n";
  for (const ReportPicture& picture : content.pictures) page += pictureTag(picture);
  return page + "</body></html>\n";
}

}  // namespace markerless_mocap
