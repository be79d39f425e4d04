#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/rig_stance.h"

namespace markerless_mocap {

/// Joints and mesh of a rig, in world axes (z up, facing +x) and the rig's unit.
struct RigMeasures {
  std::vector<Eigen::Vector3d> joint_positions;  ///< by joint of the rig
  std::vector<Eigen::Vector3f> vertices;
  std::vector<int> bone_of_vertex;  ///< bone with the largest weight per vertex; -1: none
};

/// Chooses the joints of the rig's spine that are at the heights of an adult's spine and chest. If
/// the rig has only one spine joint, the other bone is missing.
/// \param joint_positions in world axes
BoneMap withTrunkByHeight(BoneMap bones, const std::vector<Eigen::Vector3d>& joint_positions);

/// The skeleton of HumanPose in the pose of the rig. Bones that the rig does not have are placed
/// between their neighbours by an adult's proportions. Crown, finger tips and toes are taken from
/// the vertices.
HumanSkeleton rigSkeleton(const BoneMap& bones, const RigStance& stance,
                          const RigMeasures& measures);

}  // namespace markerless_mocap
