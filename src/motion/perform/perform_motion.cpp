#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "motion/clip/sampled_signal.h"
#include "motion/gait/gait_states.h"
#include "motion/motion_script.h"
#include "motion/perform/arm_pose.h"
#include "motion/perform/leg_pose.h"
#include "motion/perform/trunk_pose.h"

namespace markerless_mocap {
namespace {

constexpr double kRunDrop = 0.022;    // fraction of the stature: runners keep their knees bent
constexpr double kRunBounce = 0.016;  // fraction of the stature, half the range of the height
constexpr double kFloorReach = 0.09;  // seconds by which the limit of the legs acts ahead

/// A smooth function that is below both values.
double softMinimum(double a, double b, double softness) {
  const double apart = a - b;
  return 0.5 * (a + b - std::sqrt(apart * apart + softness * softness));
}

/// Sets the horizontal position of the hips; their height is computed later.
void placeHips(const MotionScript& script, const GaitState& now, double stature, HumanPose& pose) {
  const CurveValues shift = script.track(Track::kShift).at(now.seconds);
  const GroundPose place = now.place.shifted(shift[0] * stature, shift[1] * stature);
  const Eigen::Vector2d sway(0.003 * idleNoise(now.seconds, 30),
                             0.004 * idleNoise(now.seconds, 31));
  pose.hips.head<2>() = place.position + now.aside + sway;
  pose.hips.z() = 0.0;
}

/// Heights of the hips above which legs would be stretched; not defined in the air.
std::vector<double> legLimits(const std::vector<GaitState>& course, const MotionClip& clip,
                              const HumanSkeleton& skeleton, double standing) {
  std::vector<double> limits;
  for (size_t i = 0; i < course.size(); ++i) {
    const double leap = course[i].leap;
    limits.push_back(maxHipHeight(course[i], skeleton, clip.poses[i], standing + 0.05 + leap) -
                     leap);
  }
  return limits;
}

void setHeights(const MotionScript& script, const std::vector<GaitState>& course,
                const HumanSkeleton& skeleton, MotionClip& clip) {
  const double stature = skeleton.stature;
  const double standing = skeleton.headOf(Bone::kHips).z();
  const std::vector<double> limits = smoothLowerEnvelope(
      legLimits(course, clip, skeleton, standing), int(std::lround(kFloorReach * clip.fps)));
  for (size_t i = 0; i < course.size(); ++i) {
    const GaitState& now = course[i];
    const double drop = script.track(Track::kDrop).at(now.seconds)[0];
    const double run = now.running * (-kRunDrop + kRunBounce * now.bounce);
    const double wanted = standing + (run - drop) * stature;
    clip.poses[i].hips.z() = now.leap + softMinimum(wanted, limits[i], 0.004 * stature);
  }
}

/// Chooses the sign of each quaternion that is closer to the previous pose.
void alignSigns(MotionClip& clip) {
  for (size_t i = 1; i < clip.poses.size(); ++i)
    for (size_t b = 0; b < size_t(kBoneCount); ++b) {
      Eigen::Quaterniond& turn = clip.poses[i].R_world_bone[b];
      if (turn.dot(clip.poses[i - 1].R_world_bone[b]) < 0.0) turn.coeffs() *= -1.0;
      turn.normalize();
    }
}

}  // namespace

MotionClip performMotion(const MotionScript& script, const HumanSkeleton& skeleton, double fps) {
  if (!(fps >= 10.0 && fps <= 1000.0))
    throw std::invalid_argument("the motion's fps is " + std::to_string(fps) +
                                ", allowed is 10 to 1000");
  const std::vector<GaitState> course = sampleGait(script, skeleton, fps);
  MotionClip clip;
  clip.fps = fps;
  clip.poses.resize(course.size());
  for (size_t i = 0; i < course.size(); ++i) {
    placeHips(script, course[i], skeleton.stature, clip.poses[i]);
    poseTrunk(script, course[i], clip.poses[i]);
  }
  setHeights(script, course, skeleton, clip);
  for (size_t i = 0; i < course.size(); ++i) {
    poseLegs(course[i], skeleton, clip.poses[i]);
    poseArms(script, course[i], skeleton, clip.poses[i]);
  }
  alignSigns(clip);
  return clip;
}

}  // namespace markerless_mocap
