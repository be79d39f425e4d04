#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_volume.h"

namespace markerless_mocap {

/// An end of the skeleton that may be an extremity of the body.
struct ExtremityCandidate {
  int32_t node = -1;                                    ///< node of the graph
  Eigen::Vector3d position = Eigen::Vector3d::Zero();   ///< world metres
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  ///< of the skeleton at its end, outwards
  /// Distance from the node to the surface in that direction, metres; 0 if `cut`.
  double extent = 0.0;
  double end_radius = 0.0;   ///< of the hull along the last 10 cm, metres
  double limb_radius = 0.0;  ///< of the hull along the 20 cm before them, metres
  double branch = 0.0;       ///< path length to the nearest branching, metres
  bool cut = false;          ///< whether the end results from opening a loop
};

/// The ends that are not spurs, and the path lengths between them.
struct ExtremityCandidates {
  std::vector<ExtremityCandidate> extremities;
  /// Matrix, row by row, along the tree of shortest paths, metres.
  std::vector<double> tree_path_lengths;
  std::vector<double> shortest_path_lengths;  ///< the same with all loop edges
  double longest = 0.0;                       ///< longest path of the tree with its spurs, metres

  double treePathLength(size_t a, size_t b) const {
    return tree_path_lengths[a * extremities.size() + b];
  }
  double shortestPathLength(size_t a, size_t b) const {
    return shortest_path_lengths[a * extremities.size() + b];
  }
};

/// \param prune_ratio branches shorter than this fraction of the longest path are spurs
/// \param max_count maximum number of ends; those with the longest branches are kept
ExtremityCandidates findExtremityCandidates(const TreeGraph& graph, const TreeVolume& volume,
                                            double prune_ratio, size_t max_count);

}  // namespace markerless_mocap
