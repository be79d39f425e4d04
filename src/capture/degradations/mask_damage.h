#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Simulates the mask of a poor background subtraction: a ragged edge, holes and notches in the
/// person, specks in the background. Sizes are proportional to the image size.
/// \param mask CV_8UC1, 0 | 255
/// \param amount 0 (a copy) to 1 (hardly usable); at 0.5 about 5 % of the person's pixels are lost.
///   Throws std::invalid_argument outside this range.
/// \param stream number that depends on seed, camera and frame set
cv::Mat damagedMask(const cv::Mat& mask, double amount, uint64_t stream);

}  // namespace markerless_mocap
