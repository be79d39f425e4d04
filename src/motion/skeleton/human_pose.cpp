#include "motion/human_pose.h"

namespace markerless_mocap {
namespace {

constexpr int kSideBones = int(Bone::kRightClavicle) - int(Bone::kLeftClavicle);

struct BoneRow {
  std::string name;
  Bone parent;
};

const PerBone<BoneRow>& boneTable() {
  static const PerBone<BoneRow> table = [] {
    PerBone<BoneRow> rows;
    const auto row = [&](Bone bone, const char* name, Bone parent) {
      rows[size_t(bone)] = {name, parent};
    };
    row(Bone::kHips, "hips", Bone::kHips);
    row(Bone::kSpine, "spine", Bone::kHips);
    row(Bone::kChest, "chest", Bone::kSpine);
    row(Bone::kNeck, "neck", Bone::kChest);
    row(Bone::kHead, "head", Bone::kNeck);
    row(Bone::kLeftClavicle, "l_clavicle", Bone::kChest);
    row(Bone::kLeftUpperArm, "l_upper_arm", Bone::kLeftClavicle);
    row(Bone::kLeftForearm, "l_forearm", Bone::kLeftUpperArm);
    row(Bone::kLeftHand, "l_hand", Bone::kLeftForearm);
    row(Bone::kLeftThigh, "l_thigh", Bone::kHips);
    row(Bone::kLeftShank, "l_shank", Bone::kLeftThigh);
    row(Bone::kLeftFoot, "l_foot", Bone::kLeftShank);
    row(Bone::kLeftToes, "l_toes", Bone::kLeftFoot);
    for (int left = int(Bone::kLeftClavicle); left < int(Bone::kRightClavicle); ++left) {
      BoneRow right = rows[size_t(left)];
      right.name[0] = 'r';
      right.parent = mirrorOf(right.parent);
      rows[size_t(left + kSideBones)] = right;
    }
    return rows;
  }();
  return table;
}

}  // namespace

const std::string& boneName(Bone bone) {
  return boneTable()[size_t(bone)].name;
}

Bone parentOf(Bone bone) {
  return boneTable()[size_t(bone)].parent;
}

Bone mirrorOf(Bone bone) {
  if (bone < Bone::kLeftClavicle) return bone;
  return Bone(int(bone) + (bone < Bone::kRightClavicle ? kSideBones : -kSideBones));
}

PerBone<Eigen::Quaterniond> HumanPose::atRest() {
  PerBone<Eigen::Quaterniond> identity;
  identity.fill(Eigen::Quaterniond::Identity());
  return identity;
}

HumanPose interpolate(const HumanPose& a, const HumanPose& b, double fraction) {
  HumanPose pose;
  pose.hips = (1.0 - fraction) * a.hips + fraction * b.hips;
  for (size_t i = 0; i < size_t(kBoneCount); ++i)
    pose.R_world_bone[i] = a.R_world_bone[i].slerp(fraction, b.R_world_bone[i]);
  return pose;
}

}  // namespace markerless_mocap
