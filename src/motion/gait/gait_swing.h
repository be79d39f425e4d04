#pragma once

#include "motion/gait/gait_path.h"

namespace markerless_mocap {

/// From 0 to 1, at rest at both ends.
double minimumJerk(double u);

/// Rises from 0 to 1 at u = 0.5 and returns, at rest at both ends.
double swingBump(double u);

/// Pose of a foot in the air, u from 0 to 1.
/// \param detour offset from the straight line at its middle, metres
GroundPose swingPose(const GroundPose& from, const GroundPose& to, const Eigen::Vector2d& detour,
                     double u);

}  // namespace markerless_mocap
