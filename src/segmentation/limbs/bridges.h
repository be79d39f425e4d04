#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/eigenmap/node_grid.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Component of each node over face neighbours, numbered from 0 in the order of the components'
/// first nodes.
std::vector<uint32_t> faceComponents(const NodeGrid& grid);

/// Edges of weight 1 between nodes of different components whose voxels touch by an edge or a
/// corner. There are none inside a component, as there such a contact is a limb that passes close
/// by.
/// \param component 6-connected component of each node of the grid
std::vector<Edge> bridgeEdges(const NodeGrid& grid, const std::vector<uint32_t>& component);

}  // namespace markerless_mocap
