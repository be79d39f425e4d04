#pragma once

#include <algorithm>
#include <vector>

namespace markerless_mocap {

/// A term of a log-odds: a piecewise linear function with evenly spaced knots, constant beyond the
/// first and last one.
struct PiecewiseLinear {
  double low, high;
  std::vector<double> knots;

  double operator()(double x) const {
    const double last = double(knots.size() - 1);
    const double t = std::min(std::max((x - low) / (high - low), 0.0), 1.0) * last;
    const size_t i = std::min(size_t(t), knots.size() - 2);
    return knots[i] + (t - double(i)) * (knots[i + 1] - knots[i]);
  }
};

}  // namespace markerless_mocap
