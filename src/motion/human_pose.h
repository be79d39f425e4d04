#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

namespace markerless_mocap {

/// The bones that a motion drives. A bone rotates about its head, a joint. The head of kHips is
/// midway between the hip joints.
enum class Bone {
  kHips,
  kSpine,  ///< from the lumbar spine to the lower ribs
  kChest,  ///< up to the base of the neck
  kNeck,
  kHead,
  kLeftClavicle,
  kLeftUpperArm,
  kLeftForearm,
  kLeftHand,
  kLeftThigh,
  kLeftShank,
  kLeftFoot,
  kLeftToes,  ///< from the ball of the foot
  kRightClavicle,
  kRightUpperArm,
  kRightForearm,
  kRightHand,
  kRightThigh,
  kRightShank,
  kRightFoot,
  kRightToes,
};
constexpr int kBoneCount = 21;

/// "hips", "l_upper_arm", ...
const std::string& boneName(Bone bone);
/// The parent of a bone; kHips for kHips.
Bone parentOf(Bone bone);
/// The same bone of the other side; a bone of the trunk or head is its own mirror.
Bone mirrorOf(Bone bone);

template <typename T>
using PerBone = std::array<T, kBoneCount>;

/// Pose of a person of any size at one time. World: z up, floor at z = 0, metres.
struct HumanPose {
  /// Midway between the hip joints.
  Eigen::Vector3d hips = Eigen::Vector3d::Zero();
  /// Rotation of each bone from rest to the pose. At rest all are identity: the person stands
  /// facing +x with straight legs and both arms straight out to the sides, palms down (T-pose).
  PerBone<Eigen::Quaterniond> R_world_bone = atRest();

  const Eigen::Quaterniond& operator[](Bone bone) const { return R_world_bone[size_t(bone)]; }
  Eigen::Quaterniond& operator[](Bone bone) { return R_world_bone[size_t(bone)]; }

 private:
  static PerBone<Eigen::Quaterniond> atRest();
};

/// Interpolates between two poses: spherically, and linearly in `hips`.
/// \param fraction 0 gives a, 1 gives b
HumanPose interpolate(const HumanPose& a, const HumanPose& b, double fraction);

}  // namespace markerless_mocap
