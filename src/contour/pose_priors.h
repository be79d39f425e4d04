#pragma once

#include "contour/cone_sums.h"
#include "markerless_mocap/contour/contour_fitter.h"

namespace markerless_mocap {

/// Soft joint limits and what postures are common: joints without evidence rest there.
void addPosturePriors(const ContourPose& pose, PoseEquations& equations);

/// Draws the pose to where it is expected. \param turn_deviation rad \param move_deviation metres
void addPrediction(const ContourPose& pose, const ContourPose& expected, double turn_deviation,
                   double move_deviation, PoseEquations& equations);

/// Half the weighted sum of squares of both, to check the derivatives with.
double postureEnergy(const ContourPose& pose);
double predictionEnergy(const ContourPose& pose, const ContourPose& expected, double turn_deviation,
                        double move_deviation);

/// How far a pose is beyond its soft limits at most, radians (for directions their sine).
double worstLimitExcess(const ContourPose& pose);

}  // namespace markerless_mocap
