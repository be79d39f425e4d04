#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "motion/clip_editing.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kMinCycle = 0.6;      // seconds
constexpr double kSearchRate = 30.0;   // frames per second
constexpr double kSpeedWeight = 0.08;  // seconds: weight of the difference in speed
constexpr double kAlike = 0.2;   // radians, mean over the bones: closer poses are only blended
constexpr double kFade = 0.25;   // seconds to either side
constexpr double kBridge = 0.6;  // seconds

/// From 0 to 1 with zero velocity at both ends.
double easeInOut(double fraction) {
  return fraction * fraction * (3.0 - 2.0 * fraction);
}

Quaterniond heading(const HumanPose& pose) {
  const Vector3d forward = pose[Bone::kHips] * Vector3d::UnitX();
  return Quaterniond(AngleAxisd(std::atan2(forward.y(), forward.x()), Vector3d::UnitZ()));
}

/// Mean angle between the bones of two poses, without their headings, radians.
double difference(const HumanPose& a, const HumanPose& b) {
  const Quaterniond turn = heading(a) * heading(b).conjugate();
  double sum = 0.0;
  for (size_t i = 0; i < size_t(kBoneCount); ++i)
    sum += a.R_world_bone[i].angularDistance(turn * b.R_world_bone[i]);
  return sum / kBoneCount;
}

struct Cycle {
  size_t first = 0, last = 0;
};

/// The cycle whose first and last frame are most similar in pose and in the following pose. The
/// first frame is in the first third, the last at least kMinCycle later; of equally good cycles the
/// longer one.
Cycle bestCycle(const MotionClip& clip) {
  const size_t stride = std::max<size_t>(1, size_t(clip.fps / kSearchRate));
  const size_t shortest = size_t(kMinCycle * clip.fps);
  const size_t last = clip.poses.size() - 1;
  Cycle best{0, last};
  double min_cost = std::numeric_limits<double>::infinity();
  for (size_t a = 0; a + stride <= last && a <= last / 3; a += stride) {
    for (size_t b = a + std::max(shortest, stride); b <= last; b += stride) {
      const double now = difference(clip.poses[a], clip.poses[b]);
      const double before = difference(clip.poses[a >= stride ? a - stride : a],
                                       clip.poses[a >= stride ? b - stride : b]);
      const double change = std::abs(now - before) * clip.fps / double(stride);
      const double cost = (now + kSpeedWeight * change) / std::pow(double(b - a), 0.25);
      if (cost < min_cost) {
        min_cost = cost;
        best = {a, b};
      }
    }
  }
  return best;
}

/// The piece, moved and turned so that its first pose has the position and heading of `end`.
std::vector<HumanPose> continued(const std::vector<HumanPose>& piece, const HumanPose& end) {
  const Quaterniond turn = heading(end) * heading(piece.front()).conjugate();
  std::vector<HumanPose> out = piece;
  const Vector3d start = piece.front().hips;
  for (HumanPose& pose : out) {
    for (Quaterniond& R : pose.R_world_bone) R = turn * R;
    const double height = pose.hips.z();
    pose.hips = end.hips + turn * (pose.hips - start);
    pose.hips.z() = height;
  }
  return out;
}

/// Adds the difference between `end` and the first pose to the poses of `next`, with weights that
/// fall to 0.
void fadeIn(std::vector<HumanPose>& next, const HumanPose& end, size_t frames) {
  const HumanPose start = next.front();
  for (size_t k = 0; k < std::min(frames, next.size()); ++k) {
    const double weight = 1.0 - easeInOut(double(k) / double(frames));
    for (size_t b = 0; b < size_t(kBoneCount); ++b) {
      const Quaterniond gap = end.R_world_bone[b] * start.R_world_bone[b].conjugate();
      next[k].R_world_bone[b] =
          Quaterniond::Identity().slerp(weight, gap) * next[k].R_world_bone[b];
    }
    next[k].hips.z() += weight * (end.hips.z() - start.hips.z());
  }
}

}  // namespace

MotionClip extended(const MotionClip& clip, double duration) {
  if (clip.poses.empty()) throw std::invalid_argument("the motion has no poses");
  const size_t count = size_t(std::ceil(duration * clip.fps - 1e-3)) + 1;
  MotionClip out = clip;
  if (clip.poses.size() >= count) return out;
  if (clip.poses.size() == 1) {
    out.poses.resize(count, clip.poses[0]);
    return out;
  }
  const Cycle cycle = bestCycle(clip);
  const auto at = [&](size_t frame) { return clip.poses.begin() + long(frame); };
  const std::vector<HumanPose> piece(at(cycle.first), at(cycle.last + 1));
  const bool alike = difference(piece.front(), piece.back()) < kAlike;
  const size_t gap = alike ? 0 : size_t(kBridge * clip.fps);
  out.poses.assign(at(0), at(cycle.last + 1));
  while (out.poses.size() < count) {
    const HumanPose end = out.poses.back();
    std::vector<HumanPose> next = continued(piece, end);
    for (size_t k = 1; k <= gap; ++k)
      out.poses.push_back(interpolate(end, next.front(), easeInOut(double(k) / double(gap + 1))));
    if (alike) fadeIn(next, end, std::max<size_t>(1, size_t(2 * kFade * clip.fps)));
    // If the poses are similar, the first pose of the piece repeats the last pose and is left out.
    out.poses.insert(out.poses.end(), next.begin() + (alike ? 1 : 0), next.end());
  }
  out.poses.resize(count);
  return out;
}

}  // namespace markerless_mocap
