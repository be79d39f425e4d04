#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Flicker of lamps on mains current: brightness of an image relative to the mean. It is the sum of
/// the beat between frames and mains (a slow sine) and of a random part per frame, with equal
/// variance. Depends on its arguments only.
/// \param amount standard deviation of the gain, for example 0.01; 0 gives exactly 1
/// \param seconds capture time
/// \param stream number that depends on seed and camera; cameras with the same stream flicker
///   together
double flickerGain(double amount, double seconds, uint64_t stream);

/// Simulates the sensor: all values are multiplied by `gain`, get nearly Gaussian noise, are
/// rounded and clamped to 0 to 255. The noise depends on `stream` only.
/// \param noise_stddev standard deviation, grey levels of 255; 0: no noise
/// \param stream number that depends on seed, camera and frame set
/// \param image CV_8UC1 or CV_8UC3
void applySensor(double noise_stddev, double gain, uint64_t stream, cv::Mat& image);

}  // namespace markerless_mocap
