#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// A mask as a poor background subtraction leaves it: a ragged edge, holes and notches in the
/// person, specks in the background. Sizes go with the picture's.
/// \param mask CV_8UC1, 0 | 255
/// \param amount 0 (a copy) to 1 (hardly usable); at 0.5 about one pixel of twenty of the person is
///   lost. Throws std::invalid_argument outside.
/// \param stream a number for seed, camera and instant
cv::Mat damagedMask(const cv::Mat& mask, double amount, uint64_t stream);

}  // namespace markerless_mocap
