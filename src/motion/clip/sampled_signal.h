#pragma once

#include <vector>

namespace markerless_mocap {

/// Gaussian mean of a signal sampled at even steps; beyond its ends it is mirrored about the end
/// value, so that a straight line stays one. \param sigma in samples
std::vector<double> smoothed(const std::vector<double>& signal, double sigma);

/// Least value within `reach` samples before and after each.
std::vector<double> slidingMinimum(const std::vector<double>& signal, int reach);

/// A smooth curve that nowhere lies above the signal: the lowest value within `reach` samples,
/// averaged over as many.
std::vector<double> smoothLowerEnvelope(const std::vector<double>& signal, int reach);

}  // namespace markerless_mocap
