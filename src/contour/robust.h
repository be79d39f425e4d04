#pragma once

namespace markerless_mocap {

/// Weight of a residual r under the error r^2 / (1 + r^2 / c^2) (Geman and McClure 1987).
inline double robustWeight(double residual, double outlier) {
  const double ratio = residual / outlier, denominator = 1.0 + ratio * ratio;
  return 1.0 / (denominator * denominator);
}

}  // namespace markerless_mocap
