#include "motion/gait/foot_trajectory.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "motion/gait/gait_swing.h"

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180.0;
constexpr double kGravity = 9.81;  // m/s^2

Eigen::Quaterniond headed(double heading) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()));
}

/// Rotation by a pitch angle; toes up is positive.
Eigen::Quaterniond pitched(double pitch) {
  return Eigen::Quaterniond(Eigen::AngleAxisd(-pitch, Eigen::Vector3d::UnitY()));
}

CurveKey pitchKey(double seconds, double pitch) {
  return {seconds, CurveValues::Constant(1, pitch)};
}

/// Adds a key unless it comes too soon after the last one.
void addKey(std::vector<CurveKey>& keys, double seconds, double pitch) {
  if (keys.empty() || seconds > keys.back().seconds + 1e-4)
    keys.push_back(pitchKey(seconds, pitch));
}

}  // namespace

double leapHeight(double seconds, double flight) {
  if (seconds <= 0.0 || seconds >= flight) return 0.0;
  return 0.5 * kGravity * seconds * (flight - seconds);
}

FootTrajectory::FootTrajectory(const MotionScript& script, const GaitPlan& plan,
                               const HumanSkeleton& skeleton, bool left)
    : skeleton_(skeleton), left_(left), start_(left ? plan.left_start : plan.right_start) {
  const Eigen::Vector3d& ankle = skeleton.headOf(Bone::kLeftFoot);
  const Eigen::Vector3d& ball = skeleton.headOf(Bone::kLeftToes);
  ankle_height_ = ankle.z();
  heel_x_ = -0.028 * skeleton.stature;
  ball_x_ = ball.x() - ankle.x();
  ball_height_ = ball.z();
  for (const FootGesture& gesture : script.gestures)
    if (gesture.left == left) gestures_.push_back(gesture.keys);

  std::vector<CurveKey> keys;
  double free_from = -10.0;  // time of the last landing
  for (const GaitStep& step : plan.steps) {
    if (step.left != left) continue;
    double off_pitch = 0.0;
    const Swing swing = makeSwing(step, off_pitch);
    swings_.push_back(swing);
    const double stance = step.lift - free_from, air = step.land - step.lift;
    addKey(keys, step.lift - std::min(0.34, 0.55 * stance), 0.0);
    addKey(keys, step.lift, off_pitch);
    addKey(keys, step.lift + 0.18 * air, 1.12 * off_pitch);
    addKey(keys, step.land - 0.12 * air, 1.05 * swing.strike_pitch);
    addKey(keys, step.land, swing.strike_pitch);
    addKey(keys, step.land + 0.09, 0.0);
    free_from = step.land + 0.09;
  }
  if (!keys.empty()) pitch_ = ScriptCurve(keys);
  checkGestures(script);
}

FootTrajectory::Swing FootTrajectory::makeSwing(const GaitStep& step, double& off_pitch) const {
  const double stature = skeleton_.stature;
  const double length = (step.to.position - step.from.position).dot(step.to.forward());
  const double pace = std::clamp(length / (1.5 * skeleton_.legLength()), -1.0, 1.0);
  const double ahead = std::max(pace, 0.0);
  if (step.jump) {
    off_pitch = -45.0 * kDegree;
    return {step, -22.0 * kDegree, 0.0};
  }
  if (step.run) {
    off_pitch = -(20.0 + 45.0 * ahead) * kDegree;
    return {step, 8.0 * ahead * kDegree, (0.035 + 0.1 * ahead) * stature};
  }
  off_pitch = -(9.0 + 42.0 * ahead) * kDegree;
  return {step, (pace > 0.0 ? 26.0 : 30.0) * pace * kDegree, (0.03 + 0.02 * ahead) * stature};
}

void FootTrajectory::checkGestures(const MotionScript& script) const {
  for (const ScriptCurve& gesture : gestures_) {
    const double begin = gesture.keys().front().seconds, end = gesture.keys().back().seconds;
    for (const Swing& swing : swings_)
      if (swing.step.lift - 0.35 < end && swing.step.land + 0.1 > begin)
        throw std::invalid_argument(
            script.name + "/feet: the " + (left_ ? "left" : "right") + " foot's gesture from " +
            std::to_string(begin) + " to " + std::to_string(end) +
            " s meets a step of the path, allowed are times in which the foot stands still");
  }
}

Eigen::Vector3d FootTrajectory::ankleAbout(double pivot_x, double pivot_z, const GroundPose& place,
                                           double pitch) const {
  // The pivot is fixed on the floor at its position under the flat foot.
  const Eigen::Vector3d to_pivot(pivot_x, 0.0, pivot_z - ankle_height_);
  const Eigen::Vector3d from_flat = to_pivot - pitched(pitch) * to_pivot;
  const Eigen::Vector3d flat(place.position.x(), place.position.y(), ankle_height_);
  return flat + headed(place.heading) * from_flat;
}

FootPose FootTrajectory::standingAt(const GroundPose& place, double pitch) const {
  FootPose pose;
  pose.heading = place.heading;
  pose.foot = headed(place.heading) * pitched(pitch);
  pose.ankle = pitch < 0.0 ? ankleAbout(ball_x_, ball_height_, place, pitch)
                           : ankleAbout(heel_x_, 0.0, place, pitch);
  pose.toes = pitch < 0.0 ? headed(place.heading) : pose.foot;
  return pose;
}

FootPose FootTrajectory::swingingAt(const Swing& swing, double seconds) const {
  const GaitStep& step = swing.step;
  const double u = (seconds - step.lift) / (step.land - step.lift);
  const GroundPose place = swingPose(step.from, step.to, step.detour, u);
  const double pitch = pitch_.at(seconds)[0];
  // The pivot changes from the ball to the part that lands.
  const double on_heel = swing.strike_pitch > 0.0 ? minimumJerk(u) : 0.0;
  FootPose pose;
  pose.planted = false;
  pose.within_reach = !step.run && !step.jump;
  pose.heading = place.heading;
  pose.foot = headed(place.heading) * pitched(pitch);
  pose.toes = headed(place.heading) * pitched(on_heel * pitch);
  pose.ankle = (1.0 - on_heel) * ankleAbout(ball_x_, ball_height_, place, pitch) +
               on_heel * ankleAbout(heel_x_, 0.0, place, pitch);
  pose.ankle.z() += swing.height * swingBump(u) + step.tuck * skeleton_.stature * swingBump(u);
  if (step.jump) pose.ankle.z() += leapHeight(seconds - step.lift, step.land - step.lift);
  return pose;
}

void FootTrajectory::addGesture(double seconds, FootPose& pose) const {
  for (const ScriptCurve& gesture : gestures_) {
    if (seconds <= gesture.keys().front().seconds || seconds >= gesture.keys().back().seconds)
      continue;
    const CurveValues keyed = gesture.at(seconds);
    const double outward = left_ ? keyed[1] : -keyed[1];
    pose.ankle +=
        headed(pose.heading) * (skeleton_.stature * Eigen::Vector3d(keyed[0], outward, keyed[2]));
    const Eigen::Quaterniond turn = pitched(keyed[3] * kDegree);
    pose.foot = pose.foot * turn;
    pose.toes = pose.toes * turn;
    pose.planted = pose.within_reach = false;
  }
}

FootPose FootTrajectory::at(double seconds) const {
  GroundPose place = start_;
  for (const Swing& swing : swings_) {
    if (seconds > swing.step.lift && seconds < swing.step.land) return swingingAt(swing, seconds);
    if (seconds >= swing.step.land) place = swing.step.to;
  }
  FootPose pose = standingAt(place, pitch_.at(seconds)[0]);
  addGesture(seconds, pose);
  return pose;
}

double FootTrajectory::gestureFraction(double seconds) const {
  constexpr double kLead = 0.3;  // seconds in which the weight moves to the other foot
  double fraction = 0.0;
  for (const ScriptCurve& gesture : gestures_) {
    const double rise = (seconds - gesture.keys().front().seconds + kLead) / kLead;
    const double fall = (gesture.keys().back().seconds + kLead - seconds) / kLead;
    fraction = std::max(fraction, minimumJerk(std::clamp(std::min(rise, fall), 0.0, 1.0)));
  }
  return fraction;
}

}  // namespace markerless_mocap
