#pragma once

#include <vector>

#include "motion/gait/gait_path.h"

namespace markerless_mocap {

/// A foot's way through the air from one place on the floor to the next. Places lie under the
/// ankle.
struct GaitStep {
  bool left = false;
  double lift = 0.0, land = 0.0;  ///< seconds
  GroundPose from, to;
  Eigen::Vector2d detour = Eigen::Vector2d::Zero();  ///< round the other foot, see swingPose
  bool run = false;
  bool jump = false;
  double tuck = 0.0;  ///< of a jump, share of the stature
};

/// A stretch of time filled with steps at a steady rhythm. Step k is in the air around
/// phase k + 0.5.
struct GaitBlock {
  std::vector<double> times;   ///< rising, the phase is linear in between
  std::vector<double> phases;  ///< steps since the block's beginning, ends with a whole number
  std::vector<int> moves;      ///< which move of the script each stretch belongs to

  double phaseAt(double seconds) const;
  double timeOf(double phase) const;
  /// The script's move that is under way at a phase.
  int moveAt(double phase) const;
};

/// Where and when the feet of a script step.
struct GaitPlan {
  GroundPose left_start, right_start;
  std::vector<GaitStep> steps;  ///< in the order of their lift
  std::vector<GaitBlock> blocks;
};

GaitPlan planGait(const MotionScript& script, const GaitPath& path, const HumanSkeleton& skeleton);

}  // namespace markerless_mocap
