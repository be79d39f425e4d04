#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace markerless_mocap {

/// How far along a segment the place nearest to a point is: 0 at its start, 1 at start + step; 0 if
/// the segment has no length.
template <class Point, class Start, class Step>
double nearestFraction(const Eigen::MatrixBase<Point>& point, const Eigen::MatrixBase<Start>& start,
                       const Eigen::MatrixBase<Step>& step) {
  const double squared_length = step.squaredNorm();
  if (!(squared_length > 0.0)) return 0.0;
  return std::clamp((point - start).dot(step) / squared_length, 0.0, 1.0);
}

/// Distance of a point from the segment from a to b.
template <class Vector>
double distanceToSegment(const Vector& point, const Vector& a, const Vector& b) {
  const Vector step = b - a;
  return (point - a - nearestFraction(point, a, step) * step).norm();
}

}  // namespace markerless_mocap
