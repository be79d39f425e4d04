#include "calibration/board/chessboard_corners.h"

#include <algorithm>
#include <opencv2/calib3d.hpp>
#include <opencv2/imgproc.hpp>

#include "calibration/board/dark_squares.h"

namespace markerless_mocap {
namespace {

using Points = std::vector<cv::Point2f>;

constexpr double kSmallSide = 16;   // pixels
constexpr double kRefinedSide = 8;  // pixels; edges of smaller squares are too short

/// Of a square, pixels.
double leastSide(const Points& found, cv::Size inner) {
  double side = 1e9;
  for (int y = 0; y < inner.height; ++y)
    for (int x = 0; x < inner.width; ++x) {
      const cv::Point2f* const p = &found[y * inner.width + x];
      if (x > 0) side = std::min(side, cv::norm(p[0] - p[-1]));
      if (y > 0) side = std::min(side, cv::norm(p[0] - p[-inner.width]));
    }
  return side;
}

/// Corners on the plane that most of them lie on: where squares are small, lenses bend it little,
/// and single corners lie wrong.
Points evened(const Points& found, cv::Size inner) {
  Points flat, out;
  for (int y = 0; y < inner.height; ++y)
    for (int x = 0; x < inner.width; ++x) flat.emplace_back(float(x), float(y));
  const cv::Mat H = cv::findHomography(flat, found, cv::LMEDS);
  if (H.empty()) return found;
  cv::perspectiveTransform(flat, out, H);
  return out;
}

/// To a fraction of a pixel, by the edges that meet in each corner.
void refine(const cv::Mat& grey, cv::Size inner, Points* found) {
  const double side = leastSide(*found, inner);
  const int window = std::clamp(int(side / 3), side < kRefinedSide ? 2 : 3, 30);
  if (side < kSmallSide) *found = evened(*found, inner);
  cv::cornerSubPix(grey, *found, {window, window}, {-1, -1},
                   {cv::TermCriteria::COUNT + cv::TermCriteria::EPS, 40, 0.003});
}

/// Whether two neighbouring sides of squares may be two sides of one board in perspective.
bool areAlike(const cv::Point2f& a, const cv::Point2f& b) {
  constexpr double kDiffer = 0.4;  // of the longer side
  return cv::norm(a - b) <= kDiffer * std::max(cv::norm(a), cv::norm(b));
}

Points findBySectors(const cv::Mat& grey, cv::Size inner, int more) {
  Points found;
  const int flags = cv::CALIB_CB_NORMALIZE_IMAGE | cv::CALIB_CB_ACCURACY | more;
  if (!cv::findChessboardCornersSB(grey, inner, found, flags) || !isGrid(found, inner)) return {};
  if (leastSide(found, inner) >= kRefinedSide) refine(grey, inner, &found);
  return found;
}

/// By the quadrangles between the corners: sooner, but small ones are missed.
Points findByQuadrangles(const cv::Mat& grey, cv::Size inner, int more) {
  Points found;
  const int flags = cv::CALIB_CB_ADAPTIVE_THRESH | cv::CALIB_CB_NORMALIZE_IMAGE | more;
  if (!cv::findChessboardCorners(grey, inner, found, flags) || !isGrid(found, inner)) return {};
  refine(grey, inner, &found);
  return isGrid(found, inner) ? found : Points();
}

/// A chessboard's inner corners by rows; empty if it is not there.
Points findRows(const cv::Mat& grey, cv::Size inner, bool thorough, bool magnified = false) {
  Points found = findBySectors(grey, inner, 0);
  if (found.empty() && thorough && !magnified) found = cornersByDarkSquares(grey, inner);
  if (!found.empty() && !isGrid(found, inner)) found.clear();
  if (found.empty() && thorough) found = findBySectors(grey, inner, cv::CALIB_CB_EXHAUSTIVE);
  if (!found.empty()) return found;
  return findByQuadrangles(grey, inner, thorough ? 0 : cv::CALIB_CB_FAST_CHECK);
}

/// Part of an image about corners.
/// \param margin on each side, in the longer side of the corners' box
cv::Rect partAbout(const Points& corners, double margin, const cv::Mat& grey) {
  const cv::Rect box = cv::boundingRect(corners);
  constexpr int kSteps = 32;  // pixels: that of a board that lies still is the same
  const int by = int(margin * std::max(box.width, box.height)) + kSteps;
  const cv::Point low = (box.tl() - cv::Point(by, by)) / kSteps * kSteps;
  const cv::Point high = (box.br() + cv::Point(by, by)) / kSteps * kSteps;
  return cv::Rect(low, high) & cv::Rect(0, 0, grey.cols, grey.rows);
}

/// In the part of the image about corners that are not far off.
Points findAbout(const Points& corners, const cv::Mat& grey, cv::Size inner) {
  constexpr double kMoves = 1.5, kWhole = 0.7;  // where the part ends, corners are not exact
  const cv::Rect part = partAbout(corners, kMoves, grey);
  if (part.empty()) return {};
  Points found = findByQuadrangles(grey(part), inner, cv::CALIB_CB_FAST_CHECK);
  if (found.empty()) found = findBySectors(grey(part), inner, 0);
  for (cv::Point2f& p : found) p += cv::Point2f(part.tl());
  if (found.empty()) return {};
  const cv::Rect whole = partAbout(found, kWhole, grey);
  return (whole & part) == whole ? found : Points();
}

/// As findRows() in a magnified image.
Points findMagnified(const cv::Mat& grey, cv::Size inner, int times) {
  cv::Mat large;
  cv::resize(grey, large, {}, times, times, cv::INTER_CUBIC);
  Points found = findRows(large, inner, true, true);
  for (cv::Point2f& p : found) p = (p + cv::Point2f(0.5f, 0.5f)) / times - cv::Point2f(0.5f, 0.5f);
  return found;
}

/// A board that is not small is seen at once.
Points findAnywhere(const cv::Mat& grey, cv::Size inner, bool thorough) {
  constexpr int kSmall = 1000;  // pixels across
  Points found = findByQuadrangles(grey, inner, cv::CALIB_CB_FAST_CHECK);
  if (found.empty()) found = findRows(grey, inner, thorough);
  for (int times = 2; thorough && found.empty() && grey.cols < kSmall && times <= 3; ++times)
    found = findMagnified(grey, inner, times);
  return found;
}

/// Near where it was, if it is still there. What is found elsewhere is looked at again in the same
/// way, so that corners of a board that lies still do not depend on how it was found.
Points findNearOrAnywhere(const cv::Mat& grey, cv::Size inner, bool thorough,
                          const Points& before) {
  Points found = before.empty() ? Points() : findAbout(before, grey, inner);
  if (!found.empty()) return found;
  found = findAnywhere(grey, inner, thorough);
  const Points again = found.empty() ? Points() : findAbout(found, grey, inner);
  return again.empty() ? found : again;
}

/// Rows from the bottom of the page, columns from its left. Only the front can be seen, so x to y
/// turns left, which is right in an image with y down.
void orderAsPrinted(cv::Size inner, Points* found) {
  const ptrdiff_t width = inner.width;
  const cv::Point2f across = (*found)[width - 1] - found->front();
  const cv::Point2f along = (*found)[width * (inner.height - 1)] - found->front();
  if (across.cross(along) < 0) return;
  for (int y = 0; y < inner.height / 2; ++y)
    std::swap_ranges(found->begin() + y * width, found->begin() + (y + 1) * width,
                     found->begin() + (inner.height - 1 - y) * width);
}

/// Mean grey of the middle of the square whose lower left corner is inner corner (x, y).
double greyOfSquare(const cv::Mat& grey, const Points& found, int width, int x, int y) {
  const cv::Point2f corners[] = {found[y * width + x], found[y * width + x + 1],
                                 found[(y + 1) * width + x + 1], found[(y + 1) * width + x]};
  const cv::Point2f centre = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
  std::vector<cv::Point> inside;
  for (const cv::Point2f& corner : corners) inside.emplace_back(centre + 0.6 * (corner - centre));
  const cv::Rect box = cv::boundingRect(inside) & cv::Rect(0, 0, grey.cols, grey.rows);
  if (box.empty()) return 0;
  cv::Mat mask = cv::Mat::zeros(box.size(), CV_8UC1);
  for (cv::Point& p : inside) p -= box.tl();
  cv::fillConvexPoly(mask, inside, 255);
  return cv::mean(grey(box), mask)[0];
}

/// Positive if the squares that should be dark are darker than the others. There are as many dark
/// ones as others on a board that looks different when it is turned.
double colourAgreement(const Board& board, const cv::Mat& grey, const Points& found,
                       cv::Size inner) {
  double sum = 0;
  for (int y = 0; y + 1 < inner.height; ++y)
    for (int x = 0; x + 1 < inner.width; ++x) {
      const bool dark = board.isDark(board.options().rows - 2 - y, x + 1);
      sum += (dark ? -1 : 1) * greyOfSquare(grey, found, inner.width, x, y);
    }
  return sum;
}

}  // namespace

bool isGrid(const std::vector<cv::Point2f>& found, cv::Size inner) {
  const size_t width = size_t(inner.width), height = size_t(inner.height);
  size_t left = 0, right = 0;  // cells that turn so
  for (size_t at = 0; at < width * height; ++at) {
    const size_t x = at % width, y = at / width;
    const cv::Point2f* const p = &found[at];
    if (x + 2 < width && !areAlike(p[1] - p[0], p[2] - p[1])) return false;
    if (y + 2 < height && !areAlike(p[width] - p[0], p[2 * width] - p[width])) return false;
    if (x + 1 == width || y + 1 == height) continue;
    const cv::Point2f across = p[1] - p[0], along = p[width] - p[0];
    if (!areAlike(across, p[width + 1] - p[width])) return false;
    ++(across.cross(along) > 0 ? left : right);
  }
  return left == 0 || right == 0;
}

BoardCorners chessboardCorners(const Board& board, const cv::Mat& grey, bool thorough,
                               const BoardCorners* before) {
  const cv::Size inner(board.options().columns - 1, board.options().rows - 1);
  Points former;
  if (before && before->pixels.size() == size_t(inner.area()))
    for (const Eigen::Vector2d& p : before->pixels) former.emplace_back(float(p.x()), float(p.y()));
  Points found = findNearOrAnywhere(grey, inner, thorough, former);
  if (found.empty()) return {};
  orderAsPrinted(inner, &found);
  if (!board.looksSameTurned() && colourAgreement(board, grey, found, inner) < 0)
    std::reverse(found.begin(), found.end());
  BoardCorners out;
  for (size_t i = 0; i < found.size(); ++i) {
    out.ids.push_back(int(i));
    out.pixels.emplace_back(found[i].x, found[i].y);
  }
  return out;
}

}  // namespace markerless_mocap
