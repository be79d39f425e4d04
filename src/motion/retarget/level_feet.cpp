#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"

#include "motion/retarget.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

// Radians. A larger angle is impossible for an ankle: then the joint in the file is not a foot.
constexpr double kMaxTurn = 0.7;
// Fraction of the stature: balls up to this height above the minimum may stand.
constexpr double kLow = 0.03;

struct FootPath {
  std::vector<Vector3d> ankle, ball;
};

FootPath footPath(const MotionClip& clip, const HumanSkeleton& skeleton, Bone foot) {
  FootPath path;
  for (const HumanPose& pose : clip.poses) {
    const PerBone<Vector3d> heads = jointPositions(skeleton, pose);
    path.ankle.push_back(heads[size_t(foot)]);
    path.ball.push_back(boneEnd(skeleton, pose, heads, foot));
  }
  return path;
}

std::vector<double> heights(const std::vector<Vector3d>& places) {
  std::vector<double> z;
  for (const Vector3d& place : places) z.push_back(place.z());
  return z;
}

/// Distance moved from frame to frame, one value per frame.
std::vector<double> steps(const std::vector<Vector3d>& places) {
  std::vector<double> step(places.size(), 0.0);
  for (size_t i = 1; i < places.size(); ++i) step[i] = (places[i] - places[i - 1]).norm();
  if (step.size() > 1) step[0] = step[1];
  return step;
}

/// Frames in which the foot stands flat: ball and ankle are low, and the ball hardly moves.
std::vector<size_t> standingFrames(const FootPath& path, double floor, double stature) {
  const std::vector<double> ball = heights(path.ball), ankle = heights(path.ankle),
                            step = steps(path.ball);
  std::vector<double> low_steps, low_ankles;
  for (size_t f = 0; f < ball.size(); ++f) {
    if (ball[f] > floor + kLow * stature) continue;
    low_steps.push_back(step[f]);
    low_ankles.push_back(ankle[f]);
  }
  std::vector<size_t> frames;
  if (low_steps.empty()) return frames;
  const double slow = quantileOf(low_steps, 0.5), down = quantileOf(low_ankles, 0.6);
  for (size_t f = 0; f < ball.size(); ++f)
    if (ball[f] <= floor + kLow * stature && step[f] <= slow && ankle[f] <= down)
      frames.push_back(f);
  return frames;
}

void levelBone(MotionClip& clip, const std::vector<size_t>& frames, Bone bone) {
  std::vector<double> pitch, roll;
  for (size_t f : frames) {
    const Eigen::Matrix3d R = clip.poses[f][bone].toRotationMatrix();
    pitch.push_back(std::asin(std::clamp(R(2, 0), -1.0, 1.0)));
    roll.push_back(std::asin(std::clamp(R(2, 1), -1.0, 1.0)));
  }
  const double down = std::clamp(quantileOf(pitch, 0.5), -kMaxTurn, kMaxTurn);
  const double side = std::clamp(quantileOf(roll, 0.5), -kMaxTurn, kMaxTurn);
  const Eigen::Quaterniond fix = Eigen::Quaterniond(Eigen::AngleAxisd(down, Vector3d::UnitY())) *
                                 Eigen::Quaterniond(Eigen::AngleAxisd(-side, Vector3d::UnitX()));
  for (HumanPose& pose : clip.poses) pose[bone] = pose[bone] * fix;
}

}  // namespace

void levelFeet(MotionClip& clip, const HumanSkeleton& skeleton) {
  const FootPath left = footPath(clip, skeleton, Bone::kLeftFoot),
                 right = footPath(clip, skeleton, Bone::kRightFoot);
  std::vector<double> balls = heights(left.ball);
  for (double z : heights(right.ball)) balls.push_back(z);
  if (balls.empty()) return;
  const double floor = quantileOf(balls, 0.05);
  for (const auto& [path, foot] :
       {std::make_pair(&left, Bone::kLeftFoot), std::make_pair(&right, Bone::kRightFoot)}) {
    const std::vector<size_t> frames = standingFrames(*path, floor, skeleton.stature);
    if (frames.empty()) continue;
    levelBone(clip, frames, foot);
    levelBone(clip, frames, Bone(int(foot) + 1));
  }
}

}  // namespace markerless_mocap
