#pragma once

#include <vector>

#include "segmentation/branch.h"
#include "segmentation/eigenmap.h"

namespace markerless_mocap {

/// When a walk has come to the end of its branch.
enum class SplineTermination {
  kOrigin,    ///< the spline's end is near the origin (Hsiao 2008, 3.1.4.2 B-3)
  kOutliers,  ///< many of the nodes it was fitted to lie far from it (Sundaresan; 3.1.4.1 B-4)
};

/// Distance from the origin at which a walk stops, of its start's: for hulls whose thick core is
/// shrunk much. Where it is shrunk little, the torso is wider in the embedding and 0.3 is better.
constexpr double kStopRadius = 0.15;

/// Branches by fitting splines in the embedding from its tips inwards (Hsiao 2008, 3.1.4): start at
/// the free node furthest from the origin, take its nearest nodes, fit a cubic spline of position
/// over site value (projection on their principal direction, Eq. 3-8), propagate with the nearest
/// free nodes at the spline's end, and stop as told. The branch takes the free nodes beside the
/// curve. All lengths are relative to the start's distance from the origin, all counts to the
/// number of nodes.
/// \param count branches wanted; fewer come back when no free node is left
std::vector<Branch> splinePropagationBranches(const Eigenmap& map, SplineTermination stop,
                                              int count, double stop_radius = kStopRadius);

}  // namespace markerless_mocap
