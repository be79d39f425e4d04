#pragma once

#include <vector>

#include "motion/bone_names.h"
#include "motion/human_skeleton.h"

namespace markerless_mocap {

/// Stance of a rig in a pose with upright trunk and legs: T-pose, A-pose or arms down.
struct RigStance {
  /// From the rig's axes to world axes: z up, x the direction in which the person faces.
  Eigen::Matrix3d R_world_rig = Eigen::Matrix3d::Identity();
  /// Direction of each bone of a limb in world axes, unit length; zero if unknown.
  PerBone<Eigen::Vector3d> direction;
  /// From hip joint to ankle along thigh and shank, mean of both sides, in the rig's unit.
  double leg_length = 0.0;

  /// Rotations of the bones from the skeleton's T-pose to this stance, in world axes. Trunk, neck,
  /// head and clavicles are assumed to be equal. Limbs get the rig's directions with the smallest
  /// rotation from bone to bone, so that a hinge stays a hinge.
  PerBone<Eigen::Quaterniond> turnsFrom(const HumanSkeleton& skeleton) const;
};

/// \param positions positions of the joints in the rig's axes
/// \param stance output, set only if the result is true
/// \return false if this is no upright person, with the legs below the trunk
bool measureStance(const std::vector<NamedJoint>& joints, const BoneMap& bones,
                   const std::vector<Eigen::Vector3d>& positions, RigStance& stance);

}  // namespace markerless_mocap
