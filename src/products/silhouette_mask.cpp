#include "markerless_mocap/products/silhouette_mask.h"

#include <cstring>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

constexpr double kMaxUnknown = 0.0005;  // of a mask

void takeThreeValues(const uint8_t* __restrict from, int count, uint8_t* __restrict to) {
  for (int i = 0; i < count; ++i) {
    const uint8_t person = from[i] == kBackgroundPixel ? kBackgroundPixel : kPersonPixel;
    to[i] = from[i] == kUnknownPixel ? kUnknownPixel : person;
  }
}

}  // namespace

bool hasUnknownPixels(const cv::Mat& mask) {
  for (int y = 0; y < mask.rows; ++y)
    if (std::memchr(mask.ptr(y), kUnknownPixel, size_t(mask.cols))) return true;
  return false;
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
