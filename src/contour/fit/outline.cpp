#include "contour/fit/outline.h"

#include <algorithm>
#include <cstring>

#include "markerless_mocap/products/silhouette_mask.h"

namespace markerless_mocap {
namespace {

constexpr int kWord = 8;  // pixels compared at once

uint64_t wordAt(const uchar* row) {
  uint64_t word;
  std::memcpy(&word, row, kWord);
  return word;
}

/// Finds cracks between the pixels of `row` and those of `other`, for x in [first, last).
/// \param dx, dy half pixels from the first pixel to the crack
void compareRows(const uchar* row, const uchar* other, int first, int last, int y, int dx, int dy,
                 std::vector<Crack>& cracks) {
  for (int x = first; x < last;) {
    if (x + kWord <= last && wordAt(row + x) == wordAt(other + x)) {
      x += kWord;
      continue;
    }
    const int end = std::min(x + kWord, last);
    for (; x < end; ++x)
      if ((row[x] != 0) != (other[x] != 0) && row[x] != kUnknownPixel && other[x] != kUnknownPixel)
        cracks.push_back({int16_t(2 * x + dx), int16_t(2 * y + dy)});
  }
}

}  // namespace

void findCracks(const cv::Mat& mask, const cv::Rect& box, std::vector<Crack>& cracks) {
  // The box grows by one pixel on every side, but not to the border of the image.
  const int left = std::max(box.x - 1, 1), right = std::min(box.x + box.width, mask.cols - 2);
  const int top = std::max(box.y - 1, 1), bottom = std::min(box.y + box.height, mask.rows - 2);
  for (int y = top; y <= bottom; ++y) {
    const uchar* row = mask.ptr<uchar>(y);
    compareRows(row, row + 1, left, right, y, 1, 0, cracks);
    if (y < bottom) compareRows(row, mask.ptr<uchar>(y + 1), left, right + 1, y, 0, 1, cracks);
  }
}

Eigen::Vector2d outwardNormal(const cv::Mat& mask, const Crack& crack, int radius) {
  const double cx = 0.5 * crack.x2, cy = 0.5 * crack.y2, reach = (radius + 0.5) * (radius + 0.5);
  const int x0 = (crack.x2 >> 1) - radius, x1 = ((crack.x2 + 1) >> 1) + radius;
  const int y0 = (crack.y2 >> 1) - radius, y1 = ((crack.y2 + 1) >> 1) + radius;
  Eigen::Vector2d inward = Eigen::Vector2d::Zero();
  for (int y = y0; y <= y1; ++y) {
    const uchar* row = mask.ptr<uchar>(std::clamp(y, 0, mask.rows - 1));
    const double dy = y - cy, rest = reach - dy * dy;
    double sum = 0.0, sum_x = 0.0;
    for (int x = x0; x <= x1; ++x) {
      const double dx = x - cx, weight = std::max(0.0, rest - dx * dx);
      const double here = row[std::clamp(x, 0, mask.cols - 1)] ? weight : 0.0;
      sum += here;
      sum_x += here * dx;
    }
    inward += Eigen::Vector2d(sum_x, sum * dy);
  }
  return -inward;
}

}  // namespace markerless_mocap
