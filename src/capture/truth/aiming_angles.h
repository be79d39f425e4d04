#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Angles about two perpendicular axes, radians, that rotate the direction `rest`, perpendicular to
/// both axes, to `wanted`: wanted = exp(first t0) exp(second t1) rest. Both directions are unit
/// vectors.
Eigen::Vector2d aimingAngles(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                             const Eigen::Vector3d& rest, const Eigen::Vector3d& wanted);

}  // namespace markerless_mocap
