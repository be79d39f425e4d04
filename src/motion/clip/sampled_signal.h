#pragma once

#include <vector>

namespace markerless_mocap {

/// Gaussian smoothing of a signal with evenly spaced samples. Beyond its ends the signal is
/// mirrored about the end value, so that a straight line is not changed.
/// \param sigma standard deviation, samples
std::vector<double> smoothed(const std::vector<double>& signal, double sigma);

/// Minimum within `reach` samples before and after each sample.
std::vector<double> slidingMinimum(const std::vector<double>& signal, int reach);

/// A smooth curve that is never above the signal: the minimum within `reach` samples, averaged over
/// the same range.
std::vector<double> smoothLowerEnvelope(const std::vector<double>& signal, int reach);

}  // namespace markerless_mocap
