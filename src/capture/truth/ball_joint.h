#pragma once

#include <Eigen/Core>
#include <array>

namespace markerless_mocap {

/// Three perpendicular-in-turn axes of a joint: the first one is the parent's.
using JointAxes = std::array<Eigen::Vector3d, 3>;

/// Angles t with exp(a0 t0) exp(a1 t1) exp(a2 t2) = R (Davenport's angles), radians. Of the two
/// solutions the one is taken whose middle angle is within its limits and which is nearest to
/// `near`, with t0 and t2 in (-pi, pi]. Where the axes 0 and 2 fall together, t0 keeps near[0].
Eigen::Vector3d ballAngles(const Eigen::Matrix3d& R, const JointAxes& axes,
                           const Eigen::Vector3d& near, double middle_lower, double middle_upper);

/// Angles of two perpendicular axes that turn the direction `rest`, perpendicular to both, to
/// `wanted`, radians: wanted = exp(a0 t0) exp(a1 t1) rest. Both directions are unit vectors.
Eigen::Vector2d aimingAngles(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                             const Eigen::Vector3d& rest, const Eigen::Vector3d& wanted);

}  // namespace markerless_mocap
