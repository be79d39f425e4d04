#pragma once

#include "contour/fit/contour_fitter.h"
#include "contour/fit/pose_problem.h"

namespace markerless_mocap {

/// Fills in the evidence for each limb. `problem` must have been evaluated at the pose of the fit.
void gatherEvidence(const ContourObservation& seen, const ContourOptions& options,
                    const ContourBody& body, const PoseProblem& problem, ContourFit& fit);

}  // namespace markerless_mocap
