#pragma once

#include "contour/fit/contour_fitter.h"
#include "contour/model/normal_equations.h"

namespace markerless_mocap {

/// Adds soft joint limits and the prior of common postures: joints without evidence return to it.
void addPosturePriors(const ContourPose& pose, PoseNormalEquations& equations);

/// Pulls the arms to the hanging pose with a force that does not grow with the distance: an arm
/// without evidence comes to rest there.
void addArmRestPrior(const ContourPose& pose, PoseNormalEquations& equations);

/// The pose with both arms hanging.
ContourPose withArmsAtRest(ContourPose pose);

/// Pulls the pose to the expected one. \param turn_deviation rad \param move_deviation metres
void addMotionPrior(const ContourPose& pose, const ContourPose& expected, double turn_deviation,
                    double move_deviation, PoseNormalEquations& equations);

/// Energy of each prior: half the weighted sum of squares; pseudo-Huber loss for arms at rest.
double postureEnergy(const ContourPose& pose);
double armRestEnergy(const ContourPose& pose);

/// Maximum violation of the soft limits, radians (for directions: sine).
double maxLimitViolation(const ContourPose& pose);

}  // namespace markerless_mocap
