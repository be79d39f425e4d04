#pragma once

#include "contour/fit/contour_fitter.h"
#include "contour/model/normal_equations.h"

namespace markerless_mocap {

/// Soft joint limits and what postures are common: joints without evidence rest there.
void addPosturePriors(const ContourPose& pose, PoseNormalEquations& equations);

/// Draws the arms to where they hang, as strongly from anywhere: an arm that no contour holds comes
/// to rest there.
void addArmRestPrior(const ContourPose& pose, PoseNormalEquations& equations);

/// The pose with both arms where they hang.
ContourPose withArmsAtRest(ContourPose pose);

/// Draws the pose to where it is expected. \param turn_deviation rad \param move_deviation metres
void addMotionPrior(const ContourPose& pose, const ContourPose& expected, double turn_deviation,
                    double move_deviation, PoseNormalEquations& equations);

/// What each of them adds to the error: half the weighted sum of squares but for arms at rest.
double postureEnergy(const ContourPose& pose);
double armRestEnergy(const ContourPose& pose);
double motionPriorEnergy(const ContourPose& pose, const ContourPose& expected,
                         double turn_deviation, double move_deviation);

/// How far a pose is beyond its soft limits at most, radians (for directions their sine).
double maxLimitViolation(const ContourPose& pose);

}  // namespace markerless_mocap
