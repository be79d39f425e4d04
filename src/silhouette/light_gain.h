#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// How many times brighter the scene is than its background model: the median over a sparse grid,
/// so people may cover less than half of the image.
/// \param image CV_8UC(n); \param mean CV_32FC(n), same size
double estimateLightGain(const cv::Mat& image, const cv::Mat& mean);

}  // namespace markerless_mocap
