#pragma once

#include <vector>

#include "segmentation/eigenmap/node_grid.h"

namespace markerless_mocap {

/// Whether a tip is no end but the middle of an arm that closes a loop: a hand on the hip, on the
/// head or in the other hand. Around such a tip the hull lies on two sides, each as thin as an arm,
/// and the two hang together without what is between them.
/// \param way from the tip to each node, cube roots of the hull's volume
/// \param region of the hull's grid, without nodes; it has none afterwards either
bool closesLoop(const std::vector<double>& geodesic, NodeGrid::Region* region);

}  // namespace markerless_mocap
