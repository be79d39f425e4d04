#pragma once

#include <opencv2/core/mat.hpp>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// How many times brighter an image is than what it is compared with, and how surely.
struct LightGain {
  double gain = 1;             ///< within kDarkestGain..kBrightestGain
  double inlier_fraction = 1;  ///< of the compared pixels whose own ratio is near the gain
};

constexpr double kDarkestGain = 0.5, kBrightestGain = 1.99;

/// The most usual ratio over a sparse grid, so people may cover less than half of the image.
/// \param image CV_8UC(n), as `usual`
LightGain estimateLightGain(const cv::Mat& image, const Background& expected);
LightGain estimateLightGain(const cv::Mat& image, const cv::Mat& expected);

}  // namespace markerless_mocap
