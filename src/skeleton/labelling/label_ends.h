#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_volume.h"

namespace markerless_mocap {

/// An end of the skeleton that may be a body's.
struct SkeletonEnd {
  int32_t node = -1;                                    ///< of the graph
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< world metres
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< in which the skeleton ends
  double extent = 0.0;       ///< from the node to the surface in that direction, metres; 0 if cut
  double tip_radius = 0.0;   ///< of the hull about the last 10 cm, metres
  double limb_radius = 0.0;  ///< of the hull about the 20 cm before them
  double branch = 0.0;       ///< to the nearest branching, metres
  bool cut = false;          ///< made by opening a loop
};

/// The ends that are no spurs and how far they are from each other.
struct SkeletonEnds {
  std::vector<SkeletonEnd> ends;
  std::vector<double> tree_ways;   ///< row by row, along the tree of shortest paths, metres
  std::vector<double> short_ways;  ///< the same over all loops
  double longest = 0.0;            ///< of the tree's ways, spurs included

  double treeWay(size_t a, size_t b) const { return tree_ways[a * ends.size() + b]; }
  double shortWay(size_t a, size_t b) const { return short_ways[a * ends.size() + b]; }
};

/// \param prune_ratio branches shorter than this share of the longest path are spurs
/// \param most ends; of more those with the longest branches are taken
SkeletonEnds findEnds(const TreeGraph& graph, const TreeVolume& volume, double prune_ratio,
                      size_t most);

}  // namespace markerless_mocap
