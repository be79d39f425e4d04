#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "motion/gait/gait_steps.h"

namespace markerless_mocap {

struct FootPose {
  Eigen::Vector3d ankle = Eigen::Vector3d::Zero();
  Eigen::Quaterniond foot = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond toes = Eigen::Quaterniond::Identity();
  double heading = 0.0;  ///< radians
  bool planted = true;
  bool within_reach = true;  ///< whether the hips have to stay near enough
};

/// One foot over the whole motion: on the floor it rolls from the heel over the sole onto the ball
/// without sliding, in between it swings.
class FootTrajectory {
 public:
  /// Throws std::invalid_argument if a gesture meets a step.
  FootTrajectory(const MotionScript& script, const GaitPlan& plan, const HumanSkeleton& skeleton,
                 bool left);

  FootPose at(double seconds) const;
  /// From 0 to 1: how much of a gesture is under way, risen already a moment before.
  double gestureFraction(double seconds) const;

 private:
  struct Swing {
    GaitStep step;
    double strike_pitch;  ///< radians at landing, above 0 on the heel, below 0 on the ball
    double height;        ///< metres of clearance
  };

  Swing makeSwing(const GaitStep& step, double& off_pitch) const;
  void checkGestures(const MotionScript& script) const;
  Eigen::Vector3d ankleAbout(double pivot_x, double pivot_z, const GroundPose& place,
                             double pitch) const;
  FootPose standingAt(const GroundPose& place, double pitch) const;
  FootPose swingingAt(const Swing& swing, double seconds) const;
  void addGesture(double seconds, FootPose& pose) const;

  HumanSkeleton skeleton_;
  bool left_;
  GroundPose start_;
  std::vector<Swing> swings_;
  ScriptCurve pitch_;  ///< radians, toes up
  std::vector<ScriptCurve> gestures_;
  double ankle_height_, heel_x_, ball_x_, ball_height_;  ///< from the ankle, metres
};

/// Height of the body's middle above take-off after a leap that lasts `flight` seconds, metres.
double leapHeight(double seconds, double flight);

}  // namespace markerless_mocap
