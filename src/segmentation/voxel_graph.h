#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"
#include "segmentation/eigenmap/node_grid.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Colour bonus on an edge by the votes of the cameras that both voxels look alike (Hsiao 2008,
/// Eq. 3-15 with a = 1, b = 0.5, c = -0.9): a when all vote for it, b when at least half, c when
/// fewer; 0 when nobody could vote.
double colorBonus(int votes, int possible);

/// The graph of a hull: a node per voxel, an edge per pair of 6-neighbours (Hsiao 2008, 3.1.4.2
/// A-1), bridges between 6-connected pieces that touch by an edge or corner, as hands and shanks
/// one voxel thick do; of all that, the largest component.
struct VoxelGraph {
  WeightedGraph graph;
  NodeGrid grid{{}};
  double pitch = 0.0;                    ///< metres
  std::vector<Eigen::Vector3d> centers;  ///< of each node, world, metres
  std::vector<double> depth;             ///< of each node under the hull's surface, metres
  std::vector<uint32_t> hull_voxel;      ///< place of each node in the hull's list of voxels
  std::vector<uint32_t> left_out;        ///< hull voxels outside the largest component
};

/// Builds the graph with weight 1 on every edge, plus the colour bonus, plus `shrink_weight` on
/// each edge that has an end in the thick core (A-2: draws the torso to the embedding's origin).
/// Nodes are in the order of their lattice index, whatever the hull's order.
/// \param hull every index within its lattice, none twice
/// \param shrink_weight >= 0
VoxelGraph buildVoxelGraph(const VisualHull& hull, bool use_color_votes, double shrink_weight);

/// Nodes of the thick core: at least `share` of the greatest depth (the mean of the deepest 0.2 %)
/// under the surface.
std::vector<uint32_t> coreNodes(const std::vector<double>& depth, double fraction);

}  // namespace markerless_mocap
