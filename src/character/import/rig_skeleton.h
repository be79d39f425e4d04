#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/rig_stance.h"

namespace markerless_mocap {

/// What somebody's rig tells of a person, in world axes (z up, facing +x), in the rig's unit.
struct RigMeasures {
  std::vector<Eigen::Vector3d> joint_positions;  ///< of the rig's joints
  std::vector<Eigen::Vector3f> vertices;
  std::vector<int> bone_of_vertex;  ///< that carries most of it, -1 where nothing does
};

/// Takes those joints of the rig's spine for spine and chest that sit where an adult's do; of a rig
/// with a single one the other is missing then. \param places in world axes
BoneMap withTrunkByHeight(BoneMap bones, const std::vector<Eigen::Vector3d>& joint_positions);

/// Joints of HumanPose as the rig stands. Bones that the rig does not have are placed between their
/// neighbours by an adult's proportions; crown, finger tips and toes are taken from the vertices.
HumanSkeleton rigSkeleton(const BoneMap& bones, const RigStance& stance,
                          const RigMeasures& measures);

}  // namespace markerless_mocap
