#pragma once

#include <vector>

namespace markerless_mocap {

/// Gaussian mean; beyond the ends the values are mirrored about the end value, so that a straight
/// line stays one. \param sigma in samples; 0 changes nothing
std::vector<double> gaussianMean(const std::vector<double>& values, double sigma);

/// Least value within `reach` samples before and after each.
std::vector<double> runningMinimum(const std::vector<double>& values, long reach);

/// 0 to 1 with no speed at either end. \param share 0 to 1
inline double easedShare(double share) {
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace markerless_mocap
