#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Angles of two perpendicular axes that turn the direction `rest`, perpendicular to both, to
/// `wanted`, radians: wanted = exp(a0 t0) exp(a1 t1) rest. Both directions are unit vectors.
Eigen::Vector2d aimingAngles(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                             const Eigen::Vector3d& rest, const Eigen::Vector3d& wanted);

}  // namespace markerless_mocap
