#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "motion/human_skeleton.h"
#include "motion/motion_clip.h"

namespace markerless_mocap {

/// What a viewer would notice first about a clip.
struct MotionMeasures {
  double slide = 0.0;        ///< metres: farthest that a sole's point moves while it is down
  double sink = 0.0;         ///< metres: deepest that heel, ball or toes come below the floor
  double lowest_rise = 0.0;  ///< metres: highest that the lowest sole's point ever is
  double turn_speed = 0.0;   ///< radians per second, fastest of any bone against its parent
  int turn_bone = 0;         ///< that bone
  double turn_time = 0.0;    ///< seconds
  double bend_low = 0.0, bend_high = 0.0;  ///< radians of knees and elbows, below 0 is backwards
  double side = 0.0;                       ///< metres: farthest joint from the origin in |x| or |y|
  double top = 0.0;                        ///< metres: highest joint
  double feet_apart = 0.0;                 ///< metres: least between the feet's middle lines
  double shanks_apart = 0.0;               ///< metres: least between the shanks' axes
  double sign_jump = 0.0;  ///< smallest scalar product of successive quaternions, 1 is still
};

/// Heel, ball and toe tip in the world, of the flat foot all on z = 0.
inline std::vector<Eigen::Vector3d> solePoints(const HumanSkeleton& s, const HumanPose& pose,
                                               const PerBone<Eigen::Vector3d>& heads, bool left) {
  const Bone foot = left ? Bone::kLeftFoot : Bone::kRightFoot;
  const Bone toes = left ? Bone::kLeftToes : Bone::kRightToes;
  const Eigen::Vector3d ankle = s.headOf(foot), ball = s.headOf(toes), tip = s.tailOf(toes);
  const Eigen::Vector3d heel(-0.028 * s.stature, 0.0, -ankle.z());
  return {heads[size_t(foot)] + pose[foot] * heel,
          heads[size_t(toes)] + pose[toes] * Eigen::Vector3d(0.0, 0.0, -ball.z()),
          heads[size_t(toes)] + pose[toes] * Eigen::Vector3d(tip.x() - ball.x(), 0.0, -ball.z())};
}

/// Signed bend of a hinge joint: positive as knees and elbows bend.
inline double hingeBend(const HumanPose& pose, Bone upper, Bone lower, const Eigen::Vector3d& along,
                        const Eigen::Vector3d& hinge) {
  const Eigen::Vector3d bent = pose[upper].conjugate() * pose[lower] * along;
  return std::atan2(bent.dot(hinge.cross(along)), bent.dot(along));
}

/// Metres between two segments, to within a tenth of a foot's length.
inline double segmentGap(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c, const Eigen::Vector3d& d) {
  double least = 1e9;
  for (int i = 0; i <= 10; ++i) {
    const Eigen::Vector3d point = a + 0.1 * i * (b - a);
    const double fraction = std::clamp((point - c).dot(d - c) / (d - c).squaredNorm(), 0.0, 1.0);
    least = std::min(least, (point - c - fraction * (d - c)).norm());
  }
  return least;
}

inline void measureLegs(const HumanSkeleton& s, const HumanPose& pose,
                        const PerBone<Eigen::Vector3d>& heads, MotionMeasures& m) {
  const auto left = solePoints(s, pose, heads, true), right = solePoints(s, pose, heads, false);
  for (size_t i = 0; i < 2; ++i)
    for (size_t j = 0; j < 2; ++j)
      m.feet_apart =
          std::min(m.feet_apart, segmentGap(left[i], left[i + 1], right[j], right[j + 1]));
  const auto head = [&](Bone bone) { return heads[size_t(bone)]; };
  m.shanks_apart =
      std::min(m.shanks_apart, segmentGap(head(Bone::kLeftShank), head(Bone::kLeftFoot),
                                          head(Bone::kRightShank), head(Bone::kRightFoot)));
}

inline void measureBends(const HumanPose& pose, MotionMeasures& m) {
  const auto add = [&](double bend) {
    m.bend_low = std::min(m.bend_low, bend);
    m.bend_high = std::max(m.bend_high, bend);
  };
  const Eigen::Vector3d y = Eigen::Vector3d::UnitY(), z = Eigen::Vector3d::UnitZ();
  add(hingeBend(pose, Bone::kLeftThigh, Bone::kLeftShank, -z, y));
  add(hingeBend(pose, Bone::kRightThigh, Bone::kRightShank, -z, y));
  add(hingeBend(pose, Bone::kLeftUpperArm, Bone::kLeftForearm, y, -z));
  add(hingeBend(pose, Bone::kRightUpperArm, Bone::kRightForearm, -y, z));
}

inline MotionMeasures measure(const MotionClip& clip, const HumanSkeleton& s) {
  MotionMeasures m;
  m.sign_jump = m.feet_apart = m.shanks_apart = 1.0;
  std::vector<Eigen::Vector3d> before, stood(6, Eigen::Vector3d::Zero());
  std::vector<bool> down(6, false);
  for (size_t i = 0; i < clip.poses.size(); ++i) {
    const HumanPose& pose = clip.poses[i];
    const PerBone<Eigen::Vector3d> heads = jointPositions(s, pose);
    double minimum = 1e9;
    size_t k = 0;
    for (const bool left : {true, false})
      for (const Eigen::Vector3d& point : solePoints(s, pose, heads, left)) {
        m.sink = std::max(m.sink, -point.z());
        minimum = std::min(minimum, point.z());
        const bool now_down = point.z() < 0.0015;
        if (now_down && !down[k]) stood[k] = point;
        if (now_down) m.slide = std::max(m.slide, (point - stood[k]).head<2>().norm());
        down[k++] = now_down;
      }
    m.lowest_rise = std::max(m.lowest_rise, minimum);
    for (const Eigen::Vector3d& head : heads) {
      m.side = std::max(m.side, head.head<2>().cwiseAbs().maxCoeff());
      m.top = std::max(m.top, head.z());
    }
    measureBends(pose, m);
    measureLegs(s, pose, heads, m);
    if (i == 0) continue;
    for (int b = 0; b < kBoneCount; ++b) {
      const Bone bone = Bone(b), parent = parentOf(bone);
      const HumanPose& last = clip.poses[i - 1];
      m.sign_jump = std::min(m.sign_jump, last[bone].dot(pose[bone]));
      const Eigen::Quaterniond now = b ? pose[parent].conjugate() * pose[bone] : pose[bone];
      const Eigen::Quaterniond then = b ? last[parent].conjugate() * last[bone] : last[bone];
      const double speed = now.angularDistance(then) * clip.fps;
      if (speed <= m.turn_speed) continue;
      m.turn_speed = speed;
      m.turn_bone = b;
      m.turn_time = double(i) / clip.fps;
    }
  }
  return m;
}

}  // namespace markerless_mocap
