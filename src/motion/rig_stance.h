#pragma once

#include <vector>

#include "motion/bone_names.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// How somebody's rig stands in a pose in which its trunk and legs are upright: T-pose, A-pose or
/// arms down.
struct RigStance {
  /// From the rig's axes to z up, x the way the person faces.
  Eigen::Matrix3d R_world_rig = Eigen::Matrix3d::Identity();
  /// Where each bone of a limb points in world axes, unit length; zero where the rig does not tell.
  PerBone<Eigen::Vector3d> direction;
  /// Hip joint to ankle along thigh and shank, mean of both sides, in the rig's unit.
  double leg_length = 0.0;

  /// Turns each bone of the skeleton's T-pose into this stance, in world axes: trunk, neck, head
  /// and clavicles are taken to agree; limbs point as the rig's with the least turning from bone to
  /// bone, so that a hinge stays a hinge.
  PerBone<Eigen::Quaterniond> turnsFrom(const HumanSkeleton& skeleton) const;
};

/// \param positions of the joints, in the rig's own axes
/// \param stance written only if the result is true
/// \return false if this is no upright person: the legs do not hang below the trunk
bool measureStance(const std::vector<NamedJoint>& joints, const BoneMap& bones,
                   const std::vector<Eigen::Vector3d>& positions, RigStance& stance);

}  // namespace markerless_mocap
