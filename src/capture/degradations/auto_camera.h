#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Mean colour (blue, green, red) of an image as a camera meters it, the middle more than the
/// border.
/// \param image CV_8UC3
cv::Scalar meteredColor(const cv::Mat& image);

/// Simulates automatic exposure and white balance, which follow each image at once.
/// \param exposure 0 to 1; 1: the metered brightness becomes that of `usual`
/// \param white_balance 0 to 1; 1: the metered ratios of the channels become those of `usual`
/// \param usual metered colour of the empty room
/// \param image CV_8UC3, changed
void followLight(double exposure, double white_balance, const cv::Scalar& usual, cv::Mat& image);

}  // namespace markerless_mocap
