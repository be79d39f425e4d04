#pragma once

#include <string>
#include <vector>

#include "motion/human_pose.h"

namespace markerless_mocap {

/// A joint of somebody's rig.
struct NamedJoint {
  std::string name;
  int parent = -1;  ///< index of a joint before this one, -1 for none
};

/// Which joints of a rig are the bones of HumanPose, as indices into the rig's joints.
struct BoneMap {
  PerBone<int> joint;      ///< -1 where the rig has none
  std::vector<int> spine;  ///< from above the hips to the joint that carries both arms
  std::vector<int> neck;   ///< from above that joint to below the head

  int operator[](Bone bone) const { return joint[size_t(bone)]; }
  bool has(Bone bone) const { return joint[size_t(bone)] >= 0; }
};

/// Understands the names of the usual conversions of the CMU database, MotionBuilder, Mixamo,
/// MakeHuman, Blender's human rigs, VRM and Unity, Unreal, 3ds Max bipeds, DAZ and SMPL: upper and
/// lower case, separators, prefixes, numbers and the side's place in the name do not matter. Limbs
/// are found by name; the hips are the joint that carries both legs, the spine leads from there to
/// the joint that carries both arms. Of several joints with fitting names the one nearest to the
/// root counts. Clavicles, hands, toes, spine, neck and head may be missing.
/// \param file named in the fault
/// Throws std::invalid_argument that lists the missing bones and the names there are, if a thigh,
/// shank, foot, upper arm or forearm is missing.
BoneMap mapBones(const std::vector<NamedJoint>& joints, const std::string& file);

}  // namespace markerless_mocap
