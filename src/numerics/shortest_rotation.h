#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace markerless_mocap {

/// The shortest rotation that turns the direction of `from` to that of `to`. Neither is zero; if
/// they are opposite, the axis is any that is perpendicular to both. Eigen's FromTwoVectors(),
/// which takes each file that calls it 20 s to compile: this function is the only one that does.
Eigen::Quaterniond shortestRotation(const Eigen::Vector3d& from, const Eigen::Vector3d& to);

}  // namespace markerless_mocap
