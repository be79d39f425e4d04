#include "silhouette/shade_evidence.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace markerless_mocap {
namespace {

/// Pixels; clothes differ from shadows the more surely the larger it is.
constexpr int kTextureWindow = 13;
/// Standard deviation of the brightness ratio above which a shade is taken for clothes: where the
/// person encloses it, and elsewhere. Noise alone gives 0.015, a shadow's soft rim up to 0.05.
constexpr float kUnevenEnclosed = 0.045f, kUnevenOpen = 0.08f;
/// How far the person may be from an enclosed pixel, in image widths.
constexpr double kReach = 0.1;

/// Notes one side along a line of `n` pixels that lie `step` bytes apart.
void sweep(const uint8_t* mask, uint8_t* sides, int n, ptrdiff_t step, int reach, Side side) {
  int since = reach + 1;
  for (int i = 0; i < n; ++i, mask += step, sides += step) {
    since = *mask ? 0 : since + 1;
    if (since <= reach) *sides |= side;
  }
}

/// Below and on at least one more side.
bool isEnclosed(uint8_t sides) {
  return (sides & kBelow) && (sides & ~kBelow);
}

/// Variance of `value` among the pixels of each window where it is set.
cv::Mat localVariance(const cv::Mat& value, const cv::Mat& is_set) {
  const cv::Size window(kTextureWindow, kTextureWindow);
  cv::Mat count, sum, sum_of_squares;
  cv::boxFilter(is_set, count, CV_32F, window, {-1, -1}, false);
  cv::boxFilter(value, sum, CV_32F, window, {-1, -1}, false);
  cv::sqrBoxFilter(value, sum_of_squares, CV_32F, window, {-1, -1}, false);
  count = cv::max(count / 255, 1.0f);
  const cv::Mat mean = sum / count;
  return sum_of_squares / count - mean.mul(mean);
}

}  // namespace

cv::Mat enclosingSides(const cv::Mat& mask, int reach) {
  cv::Mat sides = cv::Mat::zeros(mask.size(), CV_8UC1);
  const cv::Mat source = mask.isContinuous() ? mask : mask.clone();
  const int width = mask.cols, height = mask.rows;
  for (int y = 0; y < height; ++y) {
    sweep(source.ptr(y), sides.ptr(y), width, 1, reach, kLeft);
    sweep(source.ptr(y) + width - 1, sides.ptr(y) + width - 1, width, -1, reach, kRight);
  }
  for (int x = 0; x < width; ++x) {
    sweep(source.ptr(0) + x, sides.ptr(0) + x, height, width, reach, kAbove);
    sweep(source.ptr(height - 1) + x, sides.ptr(height - 1) + x, height, -width, reach, kBelow);
  }
  return sides;
}

void restoreClothes(const cv::Mat& shade_ratio, cv::Mat* mask) {
  const cv::Mat is_shade = shade_ratio > 0;
  if (cv::countNonZero(is_shade) == 0) return;
  cv::Mat solid;  // without specks, which would enclose shadows
  cv::morphologyEx(*mask, solid, cv::MORPH_OPEN, cv::Mat());
  const cv::Mat sides = enclosingSides(solid, int(kReach * mask->cols));
  const cv::Mat variance = localVariance(shade_ratio, is_shade);
  for (int y = 0; y < mask->rows; ++y) {
    const uint8_t* shade = is_shade.ptr(y);
    const uint8_t* enclosed = sides.ptr(y);
    const float* v = variance.ptr<float>(y);
    uint8_t* out = mask->ptr(y);
    for (int x = 0; x < mask->cols; ++x) {
      if (!shade[x]) continue;
      const float most = isEnclosed(enclosed[x]) ? kUnevenEnclosed : kUnevenOpen;
      if (v[x] > most * most) out[x] = 255;
    }
  }
}

}  // namespace markerless_mocap
