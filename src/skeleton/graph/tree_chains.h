#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

/// A way between two vertices without a branch.
struct TreeChain {
  int32_t a, b;                ///< vertices
  double length;               ///< metres
  std::vector<int32_t> nodes;  ///< of the graph, from a to b, both included

  int32_t other(int32_t vertex) const { return vertex == a ? b : a; }
};

/// What is left of a tree when only its ends and branching nodes count as vertices.
struct TreeChains {
  std::vector<int32_t> vertices;  ///< nodes of the graph; the first one is the graph's root
  std::vector<int> degrees;       ///< chains at each vertex; 0: it is none any more
  std::vector<TreeChain> chains;
};

/// The graph's tree of shortest paths; edges that close loops are left out.
TreeChains makeChains(const TreeGraph& graph);

/// Removes a chain and makes one of two chains that only it kept apart.
void removeChain(size_t chain, TreeChains* tree);

/// Removes chains of ends that are shorter than `least` metres, the shortest first (Algorithm 3,
/// step 2). The root's is kept.
void pruneChains(double least, TreeChains* tree);

}  // namespace markerless_mocap
