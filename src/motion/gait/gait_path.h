#pragma once

#include <Eigen/Core>
#include <vector>

#include "motion/motion_script.h"

namespace markerless_mocap {

/// Somewhere on the floor, facing somewhere.
struct GroundPose {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();  ///< metres
  double heading = 0.0;                                ///< radians, turns are counted on

  Eigen::Vector2d forward() const;
  Eigen::Vector2d left() const;
  GroundPose shifted(double forward_metres, double left_metres) const;
};

/// The way of a person's middle over the floor: the script's moves one after another, joined
/// smoothly.
class GaitPath {
 public:
  GaitPath(const MotionScript& script, double fps);

  GroundPose at(double seconds) const;
  /// When each move begins; one more for the end of the last.
  const std::vector<double>& moveTimes() const { return move_times_; }

 private:
  double fps_;
  std::vector<double> move_times_;
  std::vector<double> x_, y_, heading_;  ///< sampled, beginning a second before the motion
};

}  // namespace markerless_mocap
