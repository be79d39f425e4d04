#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/graph/tree_chains.h"

namespace markerless_mocap {

/// Longest path between two nodes of a tree, metres.
double longestPathLength(const TreeGraph& graph);

/// Path lengths from the ends of a tree of chains to all its vertices.
class TreeMetric {
 public:
  TreeMetric(const TreeGraph& graph, const TreeChains& tree);

  const std::vector<int32_t>& ends() const { return ends_; }  ///< vertices with one chain
  const std::vector<int32_t>& branchings() const {
    return branchings_;
  }  ///< vertices with more than two
  /// \param end one of ends()
  double pathLength(int32_t end, int32_t vertex) const {
    return path_lengths_[size_t(end)][size_t(vertex)];
  }
  /// Length of the chain at an end.
  double branch(int32_t end) const { return branches_[size_t(end)]; }

 private:
  std::vector<int32_t> ends_, branchings_;
  std::vector<std::vector<double>> path_lengths_;  ///< by vertex; empty except for ends
  std::vector<double> branches_;
};

}  // namespace markerless_mocap
