#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/segmentation/node_grid.h"
#include "markerless_mocap/segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Edges of weight 1 that join components whose voxels touch by an edge or a corner, so that two
/// components are joined in one place only and no loop arises: those with most contacts first, all
/// contacts of a joined pair, none between pieces that are joined already.
/// \param component 6-connected component of each node of the grid
std::vector<Edge> bridgeEdges(const NodeGrid& grid, const std::vector<uint32_t>& component);

}  // namespace markerless_mocap
