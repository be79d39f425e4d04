#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

namespace markerless_mocap {

/// The bones that a motion drives. A bone turns about its head, the joint that it is named after in
/// boneName(); kHips has its head midway between the hip joints.
enum class Bone {
  kHips,
  kSpine,  ///< from the lumbar spine to the lower ribs
  kChest,  ///< up to the neck's base
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
/// The bone that carries this one; kHips for itself.
Bone parentOf(Bone bone);
/// The same bone of the other side; a bone of the middle is its own mirror.
Bone mirrorOf(Bone bone);

template <typename T>
using PerBone = std::array<T, kBoneCount>;

/// A person of any size at one instant. World: z up, floor z = 0, metres.
struct HumanPose {
  /// Midway between the hip joints.
  Eigen::Vector3d hips = Eigen::Vector3d::Zero();
  /// Turns each bone from its rest to now. At rest all are identity and the person stands facing
  /// +x with straight legs and both arms straight out to the sides, palms down (T-pose).
  PerBone<Eigen::Quaterniond> R_world_bone = atRest();

  const Eigen::Quaterniond& operator[](Bone bone) const { return R_world_bone[size_t(bone)]; }
  Eigen::Quaterniond& operator[](Bone bone) { return R_world_bone[size_t(bone)]; }

 private:
  static PerBone<Eigen::Quaterniond> atRest();
};

/// Spherical between two poses, linear in `hips`. \param share 0 gives a, 1 gives b
HumanPose interpolate(const HumanPose& a, const HumanPose& b, double fraction);

}  // namespace markerless_mocap
