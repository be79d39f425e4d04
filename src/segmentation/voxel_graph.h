#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/segmentation/body_segmenter.h"
#include "segmentation/eigenmap/node_grid.h"
#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// Colour bonus of an edge, from the votes of the cameras that both voxels have the same colour
/// (Hsiao 2008, Eq. 3-15); 0 if no camera could vote, or if neither most nor few find one colour.
double colorBonus(int votes, int possible, const ColorBonus& bonus = {});

/// How the edges of a hull's graph are weighted; see SegmentationOptions.
struct EdgeWeights {
  bool use_color_votes = false;
  double shrink_weight = 0.0;
  double shrink_degree = 0.0;
  ColorBonus color_bonus = {};
};
EdgeWeights edgeWeightsOf(const SegmentationOptions& options);

/// The graph of a hull: one node per voxel, one edge per pair of 6-neighbours (Hsiao 2008, 3.1.4.2
/// Bridges join 6-connected components that touch by an edge or corner, for example hands and
/// shanks that are one voxel thick. Only the largest component is kept.
struct VoxelGraph {
  WeightedGraph graph;
  NodeGrid grid{{}};
  double pitch = 0.0;                    ///< metres
  std::vector<Eigen::Vector3d> centers;  ///< of each node, world metres
  std::vector<double> depth;             ///< depth of each node under the hull's surface, metres
  std::vector<uint32_t> hull_voxel;      ///< index of each node in the hull's list of voxels
  std::vector<uint32_t> left_out;        ///< hull voxels outside the largest component
};

/// Builds the graph. Each edge has weight 1, plus the colour bonus, plus `shrink_weight` if it has
/// an end in the thick core (it draws the torso to the embedding's origin). The core is where the
/// hull is thick, or, as in A-2, where the degree (sum of the weights so far) is largest. Nodes are
/// sorted by lattice index.
/// \param hull all indices are within its lattice and distinct
VoxelGraph buildVoxelGraph(const VisualHull& hull, const EdgeWeights& weights = {});

/// Nodes of the thick core: their depth is at least `fraction` of the maximum depth (the mean of
/// the deepest 0.2 %).
std::vector<uint32_t> coreNodes(const std::vector<double>& depth, double fraction);

}  // namespace markerless_mocap
