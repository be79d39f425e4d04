#pragma once

#include "motion/human_pose.h"

namespace markerless_mocap {

/// Joint positions of a person in the T-pose of HumanPose, metres, standing on z = 0 with the
/// middle of the hips above the origin. Left and right are mirrored in y.
struct HumanSkeleton {
  double stature = 0.0;
  PerBone<Eigen::Vector3d> head;
  /// The far end of a bone: the next joint, or the crown, the tip of the middle finger, the tip of
  /// the toes.
  PerBone<Eigen::Vector3d> tail;

  const Eigen::Vector3d& headOf(Bone bone) const { return head[size_t(bone)]; }
  const Eigen::Vector3d& tailOf(Bone bone) const { return tail[size_t(bone)]; }
  double lengthOf(Bone bone) const { return (tailOf(bone) - headOf(bone)).norm(); }
  /// From hip joint to ankle along thigh and shank, metres.
  double legLength() const;
  /// From shoulder to wrist along upper arm and forearm, metres.
  double armLength() const;

  /// An adult of average proportions.
  /// \param stature metres, 0.5 to 2.5
  /// \param male 0: a woman, 1: a man; values in between are blended
  /// Throws std::invalid_argument outside these ranges.
  static HumanSkeleton adult(double stature, double male);
};

/// Head of each bone in the world, metres.
PerBone<Eigen::Vector3d> jointPositions(const HumanSkeleton& skeleton, const HumanPose& pose);
/// Far end of a bone in the world, metres, from the heads of jointPositions().
Eigen::Vector3d boneEnd(const HumanSkeleton& skeleton, const HumanPose& pose,
                        const PerBone<Eigen::Vector3d>& heads, Bone bone);

}  // namespace markerless_mocap
