#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Distance of each pixel to the border of a shape, pixels, negative inside and half a pixel next
/// to the border, as CV_32FC1: the chamfer distance of cv::distanceTransform with DIST_L2 and
/// DIST_MASK_5 (Borgefors 1986), to the same bits. A row is compared with the rows beside it in
/// vectors, and inside and outside are walked through together.
/// \param shape CV_8UC1, 0 outside, other values inside
cv::Mat signedDistance(const cv::Mat& shape);

}  // namespace markerless_mocap
