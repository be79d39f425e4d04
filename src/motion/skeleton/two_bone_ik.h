#pragma once

#include <Eigen/Geometry>

namespace markerless_mocap {

/// The middle joint and the far end of a limb of two bones.
struct TwoBoneIkResult {
  Eigen::Vector3d middle;
  Eigen::Vector3d end;  ///< the target, or the nearest point that the limb reaches
};

/// Inverse kinematics of a limb of two bones: bends it so that its end reaches the target, or the
/// point on the line to the target that it can reach. The middle joint points to `pole` as far as
/// possible.
/// \param upper, lower lengths, metres
/// \param max_bend maximum bend of the middle joint, radians
TwoBoneIkResult solveTwoBoneIk(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
                               double upper, double lower, const Eigen::Vector3d& pole,
                               double max_bend);

/// Soft IK: the target, if it is nearer than 0.99 of the limb's length. A target further away is
/// moved towards the root, so that the limb never becomes completely straight and its middle joint
/// does not snap.
/// \param length of both bones together, metres
Eigen::Vector3d softIkTarget(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
                             double length);

/// The rotation that maps direction `from` to `to`, and hinge `hinge_from` to `hinge_to` as well as
/// possible.
Eigen::Quaterniond turnWithHinge(const Eigen::Vector3d& from, const Eigen::Vector3d& hinge_from,
                                 const Eigen::Vector3d& to, const Eigen::Vector3d& hinge_to);

}  // namespace markerless_mocap
