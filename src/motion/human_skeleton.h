#pragma once

#include "motion/human_pose.h"

namespace markerless_mocap {

/// Where a person's joints are in the T-pose of HumanPose: metres, standing on z = 0, the hips'
/// middle above the origin. Left and right mirror each other in y.
struct HumanSkeleton {
  double stature = 0.0;
  PerBone<Eigen::Vector3d> head;
  /// The far end: the next joint, or the crown, the middle finger's tip, the toes' tip.
  PerBone<Eigen::Vector3d> tail;

  const Eigen::Vector3d& headOf(Bone bone) const { return head[size_t(bone)]; }
  const Eigen::Vector3d& tailOf(Bone bone) const { return tail[size_t(bone)]; }
  double lengthOf(Bone bone) const { return (tailOf(bone) - headOf(bone)).norm(); }
  /// Hip joint to ankle along thigh and shank.
  double legLength() const;
  /// Shoulder to wrist along upper arm and forearm.
  double armLength() const;

  /// An adult of average proportions. \param stature metres, 0.5 to 2.5 \param male 0 is a woman, 1
  /// a man, in between mixes. Throws std::invalid_argument outside.
  static HumanSkeleton adult(double stature, double male);
};

/// Head of each bone in the world.
PerBone<Eigen::Vector3d> jointPositions(const HumanSkeleton& skeleton, const HumanPose& pose);
/// Far end of a bone in the world, given the heads that jointPositions() gave.
Eigen::Vector3d boneEnd(const HumanSkeleton& skeleton, const HumanPose& pose,
                        const PerBone<Eigen::Vector3d>& heads, Bone bone);

}  // namespace markerless_mocap
