#pragma once

#include <string>
#include <vector>

#include "motion/human_pose.h"

namespace markerless_mocap {

/// A joint of a character's rig.
struct NamedJoint {
  std::string name;
  int parent = -1;  ///< index of an earlier joint; -1: none
};

/// Mapping from the bones of HumanPose to the joints of a rig, by index.
struct BoneMap {
  PerBone<int> joint;      ///< -1 if the rig has none
  std::vector<int> spine;  ///< from above the hips up to the common parent of both arms
  std::vector<int> neck;   ///< from above that joint up to below the head

  int operator[](Bone bone) const { return joint[size_t(bone)]; }
  bool has(Bone bone) const { return joint[size_t(bone)] >= 0; }
};

/// Finds the bones of a rig by the names of its joints. It knows the names of the common
/// conversions of the CMU database, MotionBuilder, Mixamo, MakeHuman, Blender's human rigs, VRM and
/// Unity, Unreal, 3ds Max bipeds, DAZ and SMPL. Case, separators, prefixes, numbers and the
/// position of the side in a name are ignored. Limbs are found by name. The hips are the common
/// parent of both legs; the spine leads from there to the common parent of both arms. Of several
/// matching joints the one nearest to the root is used. Clavicles, hands, toes, spine, neck and
/// head may be missing.
/// \param file name for the error message
/// Throws std::invalid_argument, with the missing bones and the names of the rig, if a thigh,
/// shank, foot, upper arm or forearm is missing.
BoneMap mapBones(const std::vector<NamedJoint>& joints, const std::string& file);

}  // namespace markerless_mocap
