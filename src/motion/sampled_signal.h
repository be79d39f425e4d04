#pragma once

#include <vector>

namespace markerless_mocap {

/// Gaussian mean of a signal sampled at even steps; its ends are prolonged. \param sigma in samples
std::vector<double> smoothed(const std::vector<double>& signal, double sigma);

/// A smooth curve that nowhere lies above the signal: the lowest value within `reach` samples,
/// averaged over as many.
std::vector<double> smoothFloor(const std::vector<double>& signal, int reach);

}  // namespace markerless_mocap
