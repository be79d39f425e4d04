#include <algorithm>
#include <stdexcept>

#include "markerless_mocap/motion/placement.h"
#include "motion/placement_smoothing.h"

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

constexpr double kFlight = 0.05;       // metres above the lowest around
constexpr double kAround = 0.5;        // seconds
constexpr double kSettling = 0.03;     // seconds
constexpr double kHeelBehind = 0.028;  // of the stature, behind the ankle

/// Linear between the samples that count, constant before the first and after the last.
std::vector<double> filled(const std::vector<double>& values, const std::vector<bool>& counts) {
  std::vector<double> out(values.size());
  long last = -1;
  for (long i = 0; i < long(values.size()); ++i) {
    if (!counts[size_t(i)]) continue;
    for (long k = last + 1; k <= i; ++k) {
      const double share = last < 0 ? 1.0 : double(k - last) / double(i - last);
      const double before = last < 0 ? 0.0 : values[size_t(last)];
      out[size_t(k)] = (1.0 - share) * before + share * values[size_t(i)];
    }
    last = i;
  }
  for (size_t k = size_t(last + 1); k < out.size(); ++k) out[k] = values[size_t(last)];
  return out;
}

}  // namespace

double soleHeight(const HumanSkeleton& skeleton, const HumanPose& pose) {
  const PerBone<Vector3d> heads = jointPositions(skeleton, pose);
  double lowest = heads[0].z();
  for (Bone foot : {Bone::kLeftFoot, Bone::kRightFoot}) {
    const Bone toes = Bone(int(foot) + 1);
    const auto lower = [&](Bone bone, Vector3d at_rest) {
      at_rest.z() = 0.0;
      lowest = std::min(lowest,
                        (heads[size_t(bone)] + pose[bone] * (at_rest - skeleton.headOf(bone))).z());
    };
    lower(foot, skeleton.headOf(foot) - Vector3d(kHeelBehind * skeleton.stature, 0, 0));
    lower(foot, skeleton.tailOf(foot));
    lower(toes, skeleton.tailOf(toes));
  }
  return lowest;
}

MotionClip onFloor(const MotionClip& clip, const HumanSkeleton& skeleton) {
  if (clip.poses.empty()) throw std::invalid_argument("the motion has no poses");
  std::vector<double> sole;
  for (const HumanPose& pose : clip.poses) sole.push_back(soleHeight(skeleton, pose));
  const std::vector<double> floor = runningMinimum(sole, long(kAround * clip.fps));
  std::vector<bool> stands;
  for (size_t i = 0; i < sole.size(); ++i) stands.push_back(sole[i] - floor[i] < kFlight);
  const std::vector<double> drop = gaussianMean(filled(sole, stands), kSettling * clip.fps);
  MotionClip out = clip;
  for (size_t i = 0; i < out.poses.size(); ++i) out.poses[i].hips.z() -= drop[i];
  return out;
}

}  // namespace markerless_mocap
