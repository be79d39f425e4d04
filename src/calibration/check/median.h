#pragma once

#include <vector>

namespace markerless_mocap {

/// The upper one of two in the middle; 0 of nothing.
double medianOf(std::vector<double> values);

}  // namespace markerless_mocap
