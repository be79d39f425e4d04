#include "motion/perform/trunk_pose.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180.0;

/// Angles forward, to the left, and turn to the left; radians.
struct Lean {
  double forward = 0.0, left = 0.0, turn = 0.0;

  Lean operator*(double fraction) const {
    return {fraction * forward, fraction * left, fraction * turn};
  }
  Lean operator+(const Lean& o) const {
    return {forward + o.forward, left + o.left, turn + o.turn};
  }
};

Eigen::Quaterniond rotationOf(const Lean& lean) {
  return Eigen::AngleAxisd(lean.turn, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(lean.forward, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(-lean.left, Eigen::Vector3d::UnitX());
}

Lean keyedLean(const MotionScript& script, Track track, double seconds) {
  const CurveValues keyed = script.track(track).at(seconds);
  return {kDegree * keyed[0], kDegree * keyed[1], kDegree * keyed[2]};
}

Lean restless(double seconds, int stream, double degrees) {
  return {kDegree * degrees * idleNoise(seconds, stream),
          kDegree * degrees * idleNoise(seconds, stream + 1),
          kDegree * degrees * idleNoise(seconds, stream + 2)};
}

/// The hip of the front foot moves forward, the hip of the swinging leg drops.
Lean pelvisInGait(const GaitState& now) {
  return {0.0, -3.5 * kDegree * now.support * now.moving,
          -11.0 * kDegree * now.stride * now.moving};
}

Lean trunkInGait(const GaitState& now) {
  const double speeding = std::clamp(now.speeding, -2.0, 2.0);
  return {(2.2 * now.speed + 1.6 * speeding + 5.0 * now.running) * kDegree,
          0.5 * std::atan(now.centripetal / 9.81), 0.0};
}

}  // namespace

double idleNoise(double seconds, int stream) {
  const double phase = 2.4 * stream;  // about the golden angle
  return 0.5 * std::sin(2.0 * M_PI * 0.173 * seconds + phase) +
         0.3 * std::sin(2.0 * M_PI * 0.411 * seconds + 2.7 * phase + 1.0) +
         0.2 * std::sin(2.0 * M_PI * 0.937 * seconds + 5.3 * phase + 2.0);
}

void poseTrunk(const MotionScript& script, const GaitState& now, HumanPose& pose) {
  const double t = now.seconds;
  const Lean gait_pelvis = pelvisInGait(now);
  const Lean gait_trunk = trunkInGait(now);
  const Lean pelvis = keyedLean(script, Track::kPelvis, t);
  Lean trunk = keyedLean(script, Track::kTrunk, t) + restless(t, 0, 1.0);
  trunk.forward += 0.7 * kDegree * std::sin(2.0 * M_PI * 0.27 * t);  // breathing
  // The chest stays level and turns opposite to the pelvis.
  const Lean against = gait_pelvis * -1.6;

  pose[Bone::kHips] = Eigen::AngleAxisd(now.place.heading, Eigen::Vector3d::UnitZ()) *
                      rotationOf(pelvis + gait_pelvis + gait_trunk * 0.5);
  const Lean spine = trunk + against + gait_trunk * 0.5;
  pose[Bone::kSpine] = pose[Bone::kHips] * rotationOf(spine * 0.45);
  pose[Bone::kChest] = pose[Bone::kSpine] * rotationOf(spine * 0.55);

  // The head stays nearly upright and looks ahead for any motion of the trunk.
  const Lean below = pelvis + trunk + gait_trunk;
  Lean head = keyedLean(script, Track::kHead, t) + restless(t, 7, 1.6);
  head.forward += std::clamp(-0.55 * below.forward, -45.0 * kDegree, 30.0 * kDegree);
  head.left -= 0.7 * below.left;
  head.turn += now.look + 0.6 * gait_pelvis.turn;
  pose[Bone::kNeck] = pose[Bone::kChest] * rotationOf(head * 0.4);
  pose[Bone::kHead] = pose[Bone::kChest] * rotationOf(head);
}

}  // namespace markerless_mocap
