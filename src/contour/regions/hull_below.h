#pragma once

#include "contour/model/contour_body.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// How far the hull near a body reaches below it, metres along -z; 0 if it does not, or is empty.
/// Whoever stands is held by what is under the feet, so a body whose legs are folded away above
/// their silhouettes has the hull of these legs below it.
double hullBelow(const VisualHull& hull, const ContourBody& body, const ContourPose& pose);

}  // namespace markerless_mocap
