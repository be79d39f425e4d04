#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Minimum cut on the samples of a band around an outline (Boykov and Jolly 2001): borders between
/// person and background are cheap along edges of the image.
/// \param image CV_8UC3, in a box
/// \param log_odds CV_32FC1, positive for the person
/// \param band CV_8UC1: 255 where the cut decides, 0 where log_odds alone does
/// \return CV_8UC1, 0 | 255
cv::Mat bandCut(const cv::Mat& image, const cv::Mat& log_odds, const cv::Mat& band);

}  // namespace markerless_mocap
