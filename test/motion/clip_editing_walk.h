#pragma once

#include <algorithm>
#include <cmath>

#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

namespace markerless_mocap {

inline const HumanSkeleton& person() {
  static const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 0.5);
  return skeleton;
}

inline Eigen::Quaterniond turn(double radians, const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(radians, axis));
}

inline HumanPose standing() {
  HumanPose pose;
  pose.hips = person().headOf(Bone::kHips);
  return pose;
}

constexpr double kFps = 50.0, kSpeed = 1.2, kCycle = 1.0;

/// Ahead at an even speed, hips swaying, legs and arms swinging once a second.
inline HumanPose walkingAt(double seconds) {
  const double phase = 2.0 * M_PI * seconds / kCycle;
  HumanPose pose = standing();
  pose.hips +=
      Eigen::Vector3d(kSpeed * seconds, 0.02 * std::sin(phase), 0.015 * std::cos(2.0 * phase));
  const auto swing = [&](Bone left, double angle) {
    pose[left] = turn(angle, Eigen::Vector3d::UnitY());
    pose[mirrorOf(left)] = turn(-angle, Eigen::Vector3d::UnitY());
  };
  for (Bone bone : {Bone::kLeftThigh, Bone::kLeftShank}) swing(bone, 0.4 * std::sin(phase));
  for (Bone bone : {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand})
    swing(bone, -0.5 * std::sin(phase));
  return pose;
}

inline MotionClip walk(double seconds) {
  MotionClip clip;
  clip.fps = kFps;
  for (int i = 0; i <= int(std::lround(seconds * kFps)); ++i)
    clip.poses.push_back(walkingAt(i / kFps));
  return clip;
}

inline double angleBetween(const HumanPose& a, const HumanPose& b) {
  double most = 0.0;
  for (int i = 0; i < kBoneCount; ++i)
    most = std::max(most, a[Bone(i)].angularDistance(b[Bone(i)]));
  return most;
}

/// Farthest that the hips and fastest that a bone moves from pose to pose.
struct Steps {
  double hips = 0.0, turn = 0.0;
};
inline Steps mostSteps(const MotionClip& clip) {
  Steps most;
  for (size_t i = 1; i < clip.poses.size(); ++i) {
    most.hips = std::max(most.hips, (clip.poses[i].hips - clip.poses[i - 1].hips).norm());
    most.turn = std::max(most.turn, angleBetween(clip.poses[i], clip.poses[i - 1]));
  }
  return most;
}

}  // namespace markerless_mocap
