#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Adds near-Gaussian noise of the given standard deviation (grey levels) to every channel. The
/// noise depends on nothing but `stream`, a number for seed, camera and instant.
/// \param image CV_8UC3
void addSensorNoise(double sigma_levels, uint64_t stream, cv::Mat& image);

}  // namespace markerless_mocap
