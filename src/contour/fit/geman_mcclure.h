#pragma once

namespace markerless_mocap {

/// The robust loss r^2 / (1 + r^2 / c^2) of a residual r (Geman and McClure 1987); it is less than
/// c^2.
inline double gemanMcClureLoss(double residual, double outlier) {
  const double ratio = residual / outlier;
  return residual * residual / (1.0 + ratio * ratio);
}

/// Weight of a residual for this loss.
inline double gemanMcClureWeight(double residual, double outlier) {
  const double ratio = residual / outlier, denominator = 1.0 + ratio * ratio;
  return 1.0 / (denominator * denominator);
}

}  // namespace markerless_mocap
