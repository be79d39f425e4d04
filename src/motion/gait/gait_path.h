#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/motion_script.h"

namespace markerless_mocap {

/// Position and heading on the floor.
struct GroundPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< metres
  double heading = 0.0;                                ///< radians, not wrapped

  Eigen::Vector2d forward() const;
  Eigen::Vector2d left() const;
  GroundPose shifted(double forward_metres, double left_metres) const;
};

/// The path of a person's centre over the floor: the script's moves one after another, joined
/// smoothly.
class GaitPath {
 public:
  GaitPath(const MotionScript& script, double fps);

  GroundPose at(double seconds) const;
  /// Start times of the moves and end time of the last one, seconds.
  const std::vector<double>& moveTimes() const { return move_times_; }

 private:
  double fps_;
  std::vector<double> move_times_;
  std::vector<double> x_, y_, heading_;  ///< samples, starting one second before the motion
};

}  // namespace markerless_mocap
