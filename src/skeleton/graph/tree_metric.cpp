#include "skeleton/graph/tree_metric.h"

#include <algorithm>

namespace markerless_mocap {

double longestPathLength(const TreeGraph& graph) {
  const auto furthest = std::max_element(graph.path_lengths.begin(), graph.path_lengths.end());
  const std::vector<double> path_lengths =
      treePathLengthsFrom(graph, int32_t(furthest - graph.path_lengths.begin()));
  return *std::max_element(path_lengths.begin(), path_lengths.end());
}

TreeMetric::TreeMetric(const TreeGraph& graph, const TreeChains& tree)
    : path_lengths_(tree.vertices.size()), branches_(tree.vertices.size(), 0.0) {
  for (const TreeChain& chain : tree.chains)
    for (const int32_t v : {chain.a, chain.b}) branches_[size_t(v)] = chain.length;
  for (int32_t v = 0; v < int32_t(tree.vertices.size()); ++v) {
    if (tree.degrees[size_t(v)] > 2) branchings_.push_back(v);
    if (tree.degrees[size_t(v)] != 1) continue;
    ends_.push_back(v);
    const std::vector<double> path_lengths = treePathLengthsFrom(graph, tree.vertices[size_t(v)]);
    for (const int32_t node : tree.vertices)
      path_lengths_[size_t(v)].push_back(path_lengths[size_t(node)]);
  }
}

}  // namespace markerless_mocap
