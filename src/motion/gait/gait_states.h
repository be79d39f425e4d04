#pragma once

#include <vector>

#include "motion/gait/foot_trajectory.h"

namespace markerless_mocap {

/// State of the gait at one time, from which the rest of the body is posed.
struct GaitState {
  double seconds = 0.0;
  GroundPose place;
  FootPose left, right;
  double stride = 0.0;       ///< left foot ahead of the right one, leg lengths
  double support = 0.0;      ///< 1: on the left foot, -1: on the right foot
  double moving = 0.0;       ///< 0: stands, 1: walks
  double speed = 0.0;        ///< metres per second, forward
  double speeding = 0.0;     ///< metres per second squared, forward
  double centripetal = 0.0;  ///< metres per second squared, to the left
  double look = 0.0;         ///< direction of the path ahead, radians to the left
  double running = 0.0;      ///< 0: walks, 1: runs
  double bounce = 0.0;       ///< cosine of the running rhythm; 1 in the air
  double leap = 0.0;         ///< height of the body in a jump, metres
  Eigen::Vector2d aside = Eigen::Vector2d::Zero();  ///< metres towards the supporting foot
};

/// States every 1 / fps seconds from the beginning to the end of the script.
std::vector<GaitState> sampleGait(const MotionScript& script, const HumanSkeleton& skeleton,
                                  double fps);

}  // namespace markerless_mocap
