#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "numerics/segment.h"

namespace markerless_mocap {

/// Smooth union of two signed distances; the seam is filled over about `reach` (quadratic
/// polynomial smooth minimum of Inigo Quilez).
inline double smoothUnion(double a, double b, double reach) {
  const double h = std::max(reach - std::abs(a - b), 0.0) / reach;
  return std::min(a, b) - h * h * reach * 0.25;
}

/// Smooth intersection; its edge is rounded over about `reach`.
inline double smoothIntersection(double a, double b, double reach) {
  return -smoothUnion(-a, -b, reach);
}

/// Signed distance to an ellipsoid, exact to first order at its surface.
inline double ellipsoid(const Eigen::Vector3d& p, const Eigen::Vector3d& centre,
                        const Eigen::Vector3d& half) {
  const Eigen::Vector3d q = (p - centre).cwiseQuotient(half);
  const double k = q.norm(), slope = q.cwiseQuotient(half).norm();
  return slope > 1e-9 ? k * (k - 1.0) / slope : -half.minCoeff();
}

/// Approximate signed distance to a tapered capsule from a to b with radii `at_a` and `at_b`.
inline double taperedCapsule(const Eigen::Vector3d& p, const Eigen::Vector3d& a,
                             const Eigen::Vector3d& b, double at_a, double at_b) {
  const Eigen::Vector3d ab = b - a;
  const double t = nearestFraction(p, a, ab);
  return (p - a - t * ab).norm() - (at_a + t * (at_b - at_a));
}

/// Smooth step: 0 below centre - half, 1 above centre + half.
inline double ramp(double x, double centre, double half) {
  const double t = std::clamp((x - centre + half) / (2.0 * half), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace markerless_mocap
