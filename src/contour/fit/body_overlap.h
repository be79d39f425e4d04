#pragma once

#include "contour/fit/contour_observation.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// Overlap of the body's outline and the mask of a view, 0 to 1: half the fraction of the body that
/// is in the mask plus half the fraction of the mask that is in the body (Fleischmann 2012, 5.2.1).
double viewOverlap(const ContourView& view, const Camera& camera, const ContourWorldCones& cones);

/// viewOverlap() of each view; 0 of those that are not usable.
std::vector<double> viewOverlaps(const ContourObservation& seen, const CameraRig& rig,
                                 const ContourWorldCones& cones);

/// What most views reach: more than half of them, and at least three if there are so many. Two
/// views that agree say little, as they agree on many a wrong pose. \param values of the usable
/// views, not empty
double reachedByMost(std::vector<double> values);

}  // namespace markerless_mocap
