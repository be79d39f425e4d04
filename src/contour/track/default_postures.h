#pragma once

#include <vector>

#include "contour/model/contour_pose.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Upright, bent down and crouching, in four directions each, about the middle of the hull: where a
/// search for a person may begin when neither parts nor a tree tell more. None for an empty hull.
std::vector<ContourPose> defaultPostures(const VisualHull& hull);

}  // namespace markerless_mocap
