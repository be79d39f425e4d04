#include "motion/clip_editing.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "motion/clip/sampled_signal.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kMinRadius = 0.1;

void requirePoses(const MotionClip& clip) {
  if (clip.poses.empty()) throw std::invalid_argument("the motion has no poses");
}

std::string numberText(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

MotionClip sampled(const MotionClip& clip, double start, double end, double fps) {
  MotionClip out;
  out.fps = fps;
  // A last sample within 0.001 frames of the end is included.
  const size_t count = size_t(std::floor((end - start) * fps + 1e-3)) + 1;
  for (size_t i = 0; i < count; ++i) out.poses.push_back(clip.at(start + double(i) / fps));
  return out;
}

void turnPose(HumanPose& pose, const Quaterniond& turn) {
  for (Quaterniond& R : pose.R_world_bone) R = turn * R;
}

}  // namespace

MotionClip cut(const MotionClip& clip, double start, double duration) {
  requirePoses(clip);
  if (!(start >= 0.0 && start <= clip.duration()))
    throw std::invalid_argument("start is " + numberText(start) +
                                " s, allowed is 0 to the motion's " + numberText(clip.duration()) +
                                " s");
  if (!(duration > 0.0))
    throw std::invalid_argument("duration is " + numberText(duration) +
                                " s, allowed is more than 0");
  return sampled(clip, start, std::min(start + duration, clip.duration()), clip.fps);
}

MotionClip turned(const MotionClip& clip, double yaw) {
  requirePoses(clip);
  MotionClip out = clip;
  const Quaterniond turn(AngleAxisd(yaw, Vector3d::UnitZ()));
  for (HumanPose& pose : out.poses) {
    turnPose(pose, turn);
    pose.hips = turn * pose.hips;
  }
  return out;
}

MotionClip centred(const MotionClip& clip) {
  requirePoses(clip);
  Eigen::AlignedBox3d box;
  for (const HumanPose& pose : clip.poses) box.extend(pose.hips);
  MotionClip out = clip;
  for (HumanPose& pose : out.poses) pose.hips.head<2>() -= box.center().head<2>();
  return out;
}

MotionClip bent(const MotionClip& clip, double radius) {
  requirePoses(clip);
  if (!(std::abs(radius) >= kMinRadius))
    throw std::invalid_argument("the radius to bend the path by is " + numberText(radius) +
                                " m, allowed is 0.1 m or more to either side");
  // The hips sway with each step: only the motion forward bends the path.
  constexpr double kSway = 0.2;  // seconds
  std::vector<double> x, y;
  for (const HumanPose& pose : clip.poses) {
    x.push_back(pose.hips.x());
    y.push_back(pose.hips.y());
  }
  const std::vector<double> smooth_x = smoothed(x, kSway * clip.fps),
                            smooth_y = smoothed(y, kSway * clip.fps);
  MotionClip out = clip;
  double yaw = 0.0;
  for (size_t i = 1; i < out.poses.size(); ++i) {
    const double walked = std::hypot(smooth_x[i] - smooth_x[i - 1], smooth_y[i] - smooth_y[i - 1]);
    const double turn = walked / radius;
    const Vector3d step = clip.poses[i].hips - clip.poses[i - 1].hips;
    out.poses[i].hips =
        out.poses[i - 1].hips + AngleAxisd(yaw + 0.5 * turn, Vector3d::UnitZ()) * step;
    yaw += turn;
    turnPose(out.poses[i], Quaterniond(AngleAxisd(yaw, Vector3d::UnitZ())));
  }
  return out;
}

std::string volumeViolation(const MotionClip& clip, const HumanSkeleton& skeleton,
                            const Eigen::AlignedBox3d& volume) {
  // A sole may be below the floor by this.
  constexpr double kTolerance = 0.005;
  double excess = kTolerance, reached = 0.0, limit = 0.0, time = 0.0;
  int worst = -1;
  for (size_t f = 0; f < clip.poses.size(); ++f) {
    const PerBone<Vector3d> heads = jointPositions(skeleton, clip.poses[f]);
    for (int b = 0; b < kBoneCount; ++b) {
      const Vector3d ends[] = {heads[size_t(b)], boneEnd(skeleton, clip.poses[f], heads, Bone(b))};
      for (const Vector3d& place : ends) {
        for (int axis = 0; axis < 3; ++axis) {
          const double bound = std::clamp(place[axis], volume.min()[axis], volume.max()[axis]);
          if (!(std::abs(place[axis] - bound) > excess)) continue;
          excess = std::abs(place[axis] - bound);
          reached = place[axis];
          limit = bound;
          time = double(f) / clip.fps;
          worst = axis;
        }
      }
    }
  }
  if (worst < 0) return "";
  std::ostringstream text;
  text << std::fixed << std::setprecision(1) << "the motion reaches "
       << "xyz"[worst] << " = " << std::setprecision(2) << reached << " m at "
       << std::setprecision(1) << time << " s, the volume ends at " << std::setprecision(2) << limit
       << " m; shorten, centre or bend it";
  return text.str();
}

}  // namespace markerless_mocap
