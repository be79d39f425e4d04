#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Pixel values of a silhouette mask, CV_8UC1. Unknown pixels are those whose background is not
/// known, or where the evidence is too weak: the person may be there or not.
constexpr uint8_t kBackgroundPixel = 0, kUnknownPixel = 128, kPersonPixel = 255;

/// \param mask CV_8UC1; an empty one gives false
bool hasUnknownPixels(const cv::Mat& mask);

/// The pixels that are neither background nor unknown: CV_8UC1, 0 | 255. \param mask CV_8UC1
cv::Mat personPixels(const cv::Mat& mask);

/// True if so many pixels of a mask are unknown that its contours alone do not show the person, and
/// colour images are needed. \param mask CV_8UC1, 0 | 128 | 255; an empty one gives false
bool hasUnknownBackground(const cv::Mat& mask);

/// A mask with the three values above from a grey image: 0 and 128 are kept, all other values
/// become 255. The result owns its pixels. \param grey CV_8UC1
cv::Mat maskOfThreeValues(const cv::Mat& grey);

}  // namespace markerless_mocap
