#pragma once

#include "segmentation/eigenmap.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Aligns the eigenmap of a frame with that of the previous frame. The sign of each column is
/// changed if needed, and columns of a cluster of nearly equal values (each up to 5 % above the one
/// before) are rotated among each other, so that they are nearest to the previous columns where the
/// body overlaps its previous position. Rotated columns solve the eigenproblem only up to the width
/// of their cluster.
/// \param previous_graph, previous of the previous frame, with cells of the same lattice
/// \param graph, map of this frame, with cells
/// Columns that the previous eigenmap lacks are not changed.
void alignEigenmap(const WeightedGraph& previous_graph, const Eigenmap& previous,
                   const WeightedGraph& graph, Eigenmap* map);

}  // namespace markerless_mocap
