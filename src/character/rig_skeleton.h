#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/motion/rig_stance.h"

namespace markerless_mocap {

/// What somebody's rig tells of a person, in world axes (z up, facing +x), in the rig's unit.
struct RigMeasures {
  std::vector<Eigen::Vector3d> places;  ///< of the rig's joints
  std::vector<Eigen::Vector3f> vertices;
  std::vector<int> bone_of_vertex;  ///< that carries most of it, -1 where nothing does
};

/// Joints of HumanPose as the rig stands. Bones that the rig does not have are placed between their
/// neighbours by an adult's proportions; crown, finger tips and toes are taken from the vertices.
/// \param bones spine and chest of a rig with a single spine joint may be exchanged by
/// trunkBones() before
HumanSkeleton rigSkeleton(const BoneMap& bones, const RigStance& stance,
                          const RigMeasures& measures);

/// A single joint of the spine that sits low is the spine, not the chest.
BoneMap withLowSpine(BoneMap bones, const std::vector<Eigen::Vector3d>& places);

}  // namespace markerless_mocap
