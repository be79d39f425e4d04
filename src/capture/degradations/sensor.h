#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Brightness of a picture relative to the mean, lamps on mains current: the beat between frames
/// and mains (a slow sine) and a random part of each instant, equally strong. Depends on nothing
/// but its arguments. \param amount standard deviation of the gain, e.g. 0.01; 0 gives 1 exactly
/// \param seconds of capture time
/// \param stream a number for seed and camera (cameras with one stream flicker together)
double flickerGain(double amount, double seconds, uint64_t stream);

/// What the sensor makes of a picture: every value times `gain`, plus near-Gaussian noise, rounded
/// and kept in 0 to 255. The noise depends on nothing but `stream`.
/// \param noise_stddev standard deviation in grey levels of 255, 0 for none
/// \param stream a number for seed, camera and instant
/// \param image CV_8UC1 or CV_8UC3
void applySensor(double noise_stddev, double gain, uint64_t stream, cv::Mat& image);

}  // namespace markerless_mocap
