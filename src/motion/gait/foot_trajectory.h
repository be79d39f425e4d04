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
  bool within_reach = true;  ///< whether the hips must stay near enough
};

/// Trajectory of one foot over a whole motion. On the floor the foot rolls from heel to ball
/// without sliding; in between it swings.
class FootTrajectory {
 public:
  /// Throws std::invalid_argument if a gesture overlaps a step.
  FootTrajectory(const MotionScript& script, const GaitPlan& plan, const HumanSkeleton& skeleton,
                 bool left);

  FootPose at(double seconds) const;
  /// Weight of a gesture at a time, 0 to 1; it rises shortly before the gesture.
  double gestureFraction(double seconds) const;

 private:
  struct Swing {
    GaitStep step;
    double strike_pitch;  ///< radians at landing; positive on the heel, negative on the ball
    double height;        ///< clearance, metres
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
  double ankle_height_, heel_x_, ball_x_, ball_height_;  ///< relative to the ankle, metres
};

/// Height of the body's centre above take-off, metres, `seconds` into a leap that lasts `flight`
/// seconds.
double leapHeight(double seconds, double flight);

}  // namespace markerless_mocap
