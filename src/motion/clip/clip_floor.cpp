#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "motion/clip/sampled_signal.h"
#include "motion/clip_editing.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kFlight = 0.05;           // metres above the minimum nearby
constexpr double kAround = 0.5;            // seconds
constexpr double kSettling = 0.03;         // seconds
constexpr int kSettlings = 4;              // each removes most of the remaining error
constexpr double kMaxPenetration = 0.003;  // metres
constexpr double kHeelBehind = 0.028;      // fraction of the stature, behind the ankle
constexpr double kMaxToeTurn = 1.2;        // radians
// Cosine; a foot closer to upright than this bends its toes less.
constexpr double kSoleUp = 0.25;
constexpr double kToeSeconds = 0.06;

/// Height of the point of a bone that is on the floor below `at_rest` in the T-pose.
double heightBelow(const HumanSkeleton& skeleton, const HumanPose& pose,
                   const PerBone<Vector3d>& heads, Bone bone, Vector3d at_rest) {
  at_rest.z() = 0.0;
  return (heads[size_t(bone)] + pose[bone] * (at_rest - skeleton.headOf(bone))).z();
}

/// Minimum height of both heels and balls.
double footHeight(const HumanSkeleton& skeleton, const HumanPose& pose) {
  const PerBone<Vector3d> heads = jointPositions(skeleton, pose);
  double minimum = std::numeric_limits<double>::infinity();
  for (Bone foot : {Bone::kLeftFoot, Bone::kRightFoot}) {
    const Vector3d heel =
        skeleton.headOf(foot) - Vector3d(kHeelBehind * skeleton.stature, 0.0, 0.0);
    for (const Vector3d& point : {heel, skeleton.tailOf(foot)})
      minimum = std::min(minimum, heightBelow(skeleton, pose, heads, foot, point));
  }
  return minimum;
}

/// Interpolates linearly between the samples that count; constant before the first and after the
/// last.
std::vector<double> filled(const std::vector<double>& values, const std::vector<bool>& counts) {
  std::vector<double> out(values.size());
  long last = -1;
  for (long i = 0; i < long(values.size()); ++i) {
    if (!counts[size_t(i)]) continue;
    for (long k = last + 1; k <= i; ++k) {
      const double fraction = last < 0 ? 1.0 : double(k - last) / double(i - last);
      const double before = last < 0 ? 0.0 : values[size_t(last)];
      out[size_t(k)] = (1.0 - fraction) * before + fraction * values[size_t(i)];
    }
    last = i;
  }
  for (size_t k = size_t(last + 1); k < out.size(); ++k) out[k] = values[size_t(last)];
  return out;
}

/// Distance by which each pose is lowered. It is smoothed, so that the hips do not jolt when the
/// other foot takes the weight; the remaining distance between feet and floor is smoothed again.
std::vector<double> dropsOf(const std::vector<double>& feet, double fps) {
  const std::vector<double> floor = slidingMinimum(feet, int(kAround * fps));
  std::vector<bool> stands;
  for (size_t i = 0; i < feet.size(); ++i) stands.push_back(feet[i] - floor[i] < kFlight);
  const std::vector<double> wanted = filled(feet, stands);
  std::vector<double> drops(feet.size(), 0.0), left = wanted;
  for (int round = 0; round < kSettlings; ++round) {
    const std::vector<double> more = smoothed(left, kSettling * fps);
    for (size_t i = 0; i < drops.size(); ++i) {
      drops[i] += more[i];
      left[i] -= more[i];
    }
  }
  return drops;
}

/// Angle about the toes' axis that lifts a tip from below the floor onto it; 0 if it is above. Toes
/// of a foot that is upright or lies on its back are not changed.
double toeBend(const HumanSkeleton& skeleton, const HumanPose& pose, Bone toes) {
  const PerBone<Vector3d> heads = jointPositions(skeleton, pose);
  if (heightBelow(skeleton, pose, heads, toes, skeleton.tailOf(toes)) >= 0.0) return 0.0;
  Vector3d at_rest = skeleton.tailOf(toes) - skeleton.headOf(toes);
  at_rest.z() = -skeleton.headOf(toes).z();
  const Vector3d axis = -(pose[toes] * Vector3d::UnitY());
  const Vector3d tip = pose[toes] * at_rest;
  // The height of the tip as a function of the angle is still + reach cos(angle - top).
  const double still = axis.z() * axis.dot(tip);
  const double cosine = tip.z() - still, sine = axis.cross(tip).z();
  const double reach = std::hypot(cosine, sine), top = std::atan2(sine, cosine);
  const double floor = std::clamp((-heads[size_t(toes)].z() - still) / reach, -1.0, 1.0);
  const double sole_up = (pose[parentOf(toes)] * Vector3d::UnitZ()).z();
  const double fraction = std::clamp(sole_up / kSoleUp, 0.0, 1.0);
  return std::clamp(top - std::acos(floor), 0.0, fraction * kMaxToeTurn);
}

/// Bends toes up that point into the floor, smoothly in time.
void bendToes(const HumanSkeleton& skeleton, MotionClip& clip) {
  for (Bone toes : {Bone::kLeftToes, Bone::kRightToes}) {
    std::vector<double> down;
    for (const HumanPose& pose : clip.poses) down.push_back(-toeBend(skeleton, pose, toes));
    down = smoothLowerEnvelope(down, int(std::ceil(kToeSeconds * clip.fps)));
    for (size_t i = 0; i < clip.poses.size(); ++i)
      clip.poses[i][toes] = clip.poses[i][toes] * Eigen::AngleAxisd(down[i], Vector3d::UnitY());
  }
}

void raiseWhatSinks(const HumanSkeleton& skeleton, MotionClip& clip) {
  std::vector<double> excess;
  for (const HumanPose& pose : clip.poses)
    excess.push_back(std::min(0.0, soleHeight(skeleton, pose) + kMaxPenetration));
  excess = smoothLowerEnvelope(excess, int(std::ceil(kSettling * clip.fps)));
  for (size_t i = 0; i < clip.poses.size(); ++i) clip.poses[i].hips.z() -= excess[i];
}

}  // namespace

double soleHeight(const HumanSkeleton& skeleton, const HumanPose& pose) {
  const PerBone<Vector3d> heads = jointPositions(skeleton, pose);
  double minimum = footHeight(skeleton, pose);
  for (Bone toes : {Bone::kLeftToes, Bone::kRightToes})
    minimum = std::min(minimum, heightBelow(skeleton, pose, heads, toes, skeleton.tailOf(toes)));
  return minimum;
}

MotionClip onFloor(const MotionClip& clip, const HumanSkeleton& skeleton) {
  if (clip.poses.empty()) throw std::invalid_argument("the motion has no poses");
  std::vector<double> feet;
  for (const HumanPose& pose : clip.poses) feet.push_back(footHeight(skeleton, pose));
  const std::vector<double> drops = dropsOf(feet, clip.fps);
  MotionClip out = clip;
  for (size_t i = 0; i < out.poses.size(); ++i) out.poses[i].hips.z() -= drops[i];
  bendToes(skeleton, out);
  raiseWhatSinks(skeleton, out);
  return out;
}

}  // namespace markerless_mocap
