#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

/// A path between two vertices without a branching in between.
struct TreeChain {
  int32_t a, b;                ///< vertices
  double length;               ///< metres
  std::vector<int32_t> nodes;  ///< nodes of the graph from a to b, both inclusive

  int32_t other(int32_t vertex) const { return vertex == a ? b : a; }
};

/// A tree whose vertices are only its ends and branching nodes.
struct TreeChains {
  std::vector<int32_t> vertices;  ///< nodes of the graph; the first one is the graph's root
  std::vector<int> degrees;       ///< number of chains at each vertex; 0: the vertex is removed
  std::vector<TreeChain> chains;
};

/// The graph's tree of shortest paths, without the edges that close loops.
TreeChains makeChains(const TreeGraph& graph);

/// Removes a chain; if two chains are left at its vertex, they are joined.
void removeChain(size_t chain, TreeChains* tree);

/// Removes chains at ends that are shorter than `min_length` metres, the shortest first (Algorithm
/// 3, step 2). The root's chain is kept.
void pruneChains(double min_length, TreeChains* tree);

}  // namespace markerless_mocap
