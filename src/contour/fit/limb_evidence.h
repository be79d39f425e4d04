#pragma once

#include "contour/fit/contour_fitter.h"
#include "contour/fit/pose_problem.h"

namespace markerless_mocap {

/// Fills in what speaks for each limb where the problem was last evaluated, at the fit's pose.
void gatherEvidence(const ContourObservation& seen, const ContourOptions& options,
                    const ContourBody& body, const PoseProblem& problem, ContourFit& fit);

}  // namespace markerless_mocap
