#pragma once

#include <vector>

#include "markerless_mocap/segmentation/branch.h"
#include "markerless_mocap/segmentation/eigenmap.h"

namespace markerless_mocap {

/// Branches by fitting splines in the embedding from its tips inwards (Hsiao 2008, 3.1.4.2 B):
/// start at the free node furthest from the origin, take its nearest nodes, fit a cubic spline of
/// position over site value (projection on their principal direction, Eq. 3-8), propagate with the
/// nearest free nodes at the spline's end, and stop near the origin. The branch takes the free
/// nodes beside the curve. All lengths are relative to the start's distance from the origin. \param
/// count branches wanted; fewer come back when no free node is left
std::vector<Branch> splineWalkBranches(const Eigenmap& map, int count);

}  // namespace markerless_mocap
