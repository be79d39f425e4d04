#pragma once

#include <opencv2/core/mat.hpp>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// Brightness of an image relative to a reference, and how many pixels agree with it.
struct LightGain {
  double gain = 1;             ///< clamped to kDarkestGain..kBrightestGain
  double inlier_fraction = 1;  ///< fraction of the compared pixels whose ratio is near the gain
};

constexpr double kDarkestGain = 0.5, kBrightestGain = 1.99;

/// Robust mean of the brightness ratio over a sparse grid: the median, then the mean of the
/// inliers. People may cover less than half of the image.
/// \param image CV_8UC1 or CV_8UC3, like `expected`
LightGain estimateLightGain(const cv::Mat& image, const Background& expected);
LightGain estimateLightGain(const cv::Mat& image, const cv::Mat& expected);

/// Whether the image is far brighter or darker than expected, and most of it is white or black, so
/// that it says nothing about the scene.
bool isClipped(const cv::Mat& image, double gain);

}  // namespace markerless_mocap
