#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_volume.h"

namespace markerless_mocap {

/// An end of the skeleton that may be a body's.
struct ExtremityCandidate {
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
struct ExtremityCandidates {
  std::vector<ExtremityCandidate> extremities;
  std::vector<double> tree_path_lengths;  ///< row by row, along the tree of shortest paths, metres
  std::vector<double> shortest_path_lengths;  ///< the same over all loops
  double longest = 0.0;                       ///< of the tree's ways, spurs included

  double treePathLength(size_t a, size_t b) const {
    return tree_path_lengths[a * extremities.size() + b];
  }
  double shortestPathLength(size_t a, size_t b) const {
    return shortest_path_lengths[a * extremities.size() + b];
  }
};

/// \param prune_ratio branches shorter than this share of the longest path are spurs
/// \param most ends; of more those with the longest branches are taken
ExtremityCandidates findExtremityCandidates(const TreeGraph& graph, const TreeVolume& volume,
                                            double prune_ratio, size_t most);

}  // namespace markerless_mocap
