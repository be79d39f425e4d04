#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace markerless_mocap {

/// Rotation by `angle`, radians, about an axis of the frame.
inline Eigen::Matrix3d rotX(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Eigen::Matrix3d() << 1, 0, 0, 0, c, -s, 0, s, c).finished();
}
inline Eigen::Matrix3d rotY(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Eigen::Matrix3d() << c, 0, s, 0, 1, 0, -s, 0, c).finished();
}
inline Eigen::Matrix3d rotZ(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return (Eigen::Matrix3d() << c, -s, 0, s, c, 0, 0, 0, 1).finished();
}

/// Angle of the rotation about `axis`, a unit vector, that brings `from` nearest to `to`, radians.
inline double angleAbout(const Eigen::Vector3d& axis, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  const Eigen::Vector3d f = from - axis * axis.dot(from), t = to - axis * axis.dot(to);
  return std::atan2(axis.dot(f.cross(t)), f.dot(t));
}

/// The angle plus the number of full turns that brings it nearest to `near`, radians.
inline double nearestTurn(double angle, double near) {
  return angle + 2 * M_PI * std::round((near - angle) / (2 * M_PI));
}

}  // namespace markerless_mocap
