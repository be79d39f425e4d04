#include "markerless_mocap/products/silhouette_mask.h"

#include <algorithm>
#include <cstring>
#include <opencv2/core.hpp>
#include <vector>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr double kMaxUnknown = 0.0005;  // of a mask

void takeThreeValues(const uint8_t* __restrict from, int count, uint8_t* __restrict to) {
  for (int i = 0; i < count; ++i) {
    const uint8_t person = from[i] == kBackgroundPixel ? kBackgroundPixel : kPersonPixel;
    to[i] = from[i] == kUnknownPixel ? kUnknownPixel : person;
  }
}

/// Adds the row's bits to those of all rows. Returns whether it has any.
MOCAP_VECTORISED bool addRow(const uint8_t* __restrict row, int count, uint8_t* __restrict all) {
  uint8_t any = 0;
  for (int i = 0; i < count; ++i) {
    any |= row[i];
    all[i] |= row[i];
  }
  return any != 0;
}

}  // namespace

bool hasUnknownPixels(const cv::Mat& mask) {
  for (int y = 0; y < mask.rows; ++y)
    if (std::memchr(mask.ptr(y), kUnknownPixel, size_t(mask.cols))) return true;
  return false;
}

cv::Rect shownBox(const cv::Mat& mask) {
  std::vector<uint8_t> columns(size_t(mask.cols), 0);
  int top = -1, bottom = -1;
  for (int y = 0; y < mask.rows; ++y) {
    if (!addRow(mask.ptr(y), mask.cols, columns.data())) continue;
    if (top < 0) top = y;
    bottom = y;
  }
  if (top < 0) return {};
  const auto shown = [](uint8_t column) { return column != kBackgroundPixel; };
  const auto left = std::find_if(columns.begin(), columns.end(), shown);
  const auto right = std::find_if(columns.rbegin(), columns.rend(), shown).base();
  return {int(left - columns.begin()), top, int(right - left), bottom - top + 1};
}

cv::Mat personPixels(const cv::Mat& mask) {
  return (mask != kBackgroundPixel) & (mask != kUnknownPixel);
}

bool hasUnknownBackground(const cv::Mat& mask) {
  return hasUnknownPixels(mask) &&
         cv::countNonZero(mask == kUnknownPixel) > kMaxUnknown * double(mask.total());
}

cv::Mat maskOfThreeValues(const cv::Mat& grey) {
  cv::Mat mask(grey.size(), CV_8UC1);
  for (int y = 0; y < grey.rows; ++y) takeThreeValues(grey.ptr(y), grey.cols, mask.ptr(y));
  return mask;
}

}  // namespace markerless_mocap
