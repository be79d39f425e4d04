#pragma once

#include "segmentation/eigenmap.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Makes a frame's eigenmap look like that of the frame before: turns each column's sign and,
/// within a cluster of near-equal values (each at most 5 % above the one before), the columns among
/// each other, so that they come nearest to the previous ones where the body is near where it was.
/// Within a cluster the columns are then solutions only up to the cluster's own width.
/// \param previous_graph, previous of the frame before, with cells of the same lattice
/// \param graph, map of this frame, with cells
/// Columns that the previous eigenmap lacks stay as they are.
void alignEigenmap(const WeightedGraph& previous_graph, const Eigenmap& previous,
                   const WeightedGraph& graph, Eigenmap* map);

}  // namespace markerless_mocap
