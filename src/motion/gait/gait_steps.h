#pragma once

#include <vector>

#include "motion/gait/gait_path.h"

namespace markerless_mocap {

/// One step: the motion of a foot through the air from one position on the floor to the next.
/// Positions are under the ankle.
struct GaitStep {
  bool left = false;
  double lift = 0.0, land = 0.0;  ///< seconds
  GroundPose from, to;
  Eigen::Vector2d detour = Eigen::Vector2d::Zero();  ///< around the other foot, see swingPose()
  bool run = false;
  bool jump = false;
  double tuck = 0.0;  ///< of a jump, fraction of the stature
};

/// A time interval with steps at a steady rhythm. Step k is in the air around phase k + 0.5.
struct GaitBlock {
  std::vector<double> times;   ///< ascending; the phase is linear in between
  std::vector<double> phases;  ///< steps since the beginning of the block; the last is an integer
  std::vector<int> moves;      ///< the script's move of each interval

  double phaseAt(double seconds) const;
  double timeOf(double phase) const;
  /// The script's move at a phase.
  int moveAt(double phase) const;
};

/// Positions and times of all steps of a script.
struct GaitPlan {
  GroundPose left_start, right_start;
  std::vector<GaitStep> steps;  ///< in the order of their lift
  std::vector<GaitBlock> blocks;
};

GaitPlan planGait(const MotionScript& script, const GaitPath& path, const HumanSkeleton& skeleton);

}  // namespace markerless_mocap
