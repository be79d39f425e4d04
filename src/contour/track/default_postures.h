#pragma once

#include <vector>

#include "contour/model/contour_pose.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Upright, bent and crouching poses, in four directions each, at the centre of the hull: start
/// poses for a search without any proposal. Empty for an empty hull.
std::vector<ContourPose> defaultPostures(const VisualHull& hull);

}  // namespace markerless_mocap
