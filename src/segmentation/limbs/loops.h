#pragma once

#include <vector>

#include "segmentation/eigenmap/node_grid.h"

namespace markerless_mocap {

/// Whether an extremity is in fact the middle of an arm that closes a loop, with the hand on the
/// hip, on the head or in the other hand. On both sides of such a point the hull is as thin as an
/// arm, and the two sides are connected without the nodes between them.
/// \param geodesic distances from the extremity to each node, cube roots of the hull's volume
/// \param region empty region of the hull's grid, used as scratch memory; empty again afterwards
bool closesLoop(const std::vector<double>& geodesic, NodeGrid::Region* region);

}  // namespace markerless_mocap
