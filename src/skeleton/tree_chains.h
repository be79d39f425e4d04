#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/tree_graph.h"

namespace markerless_mocap {

/// A way between two vertices without a branch.
struct TreeChain {
  int32_t a, b;                ///< vertices; the same one for a loop that starts where it ends
  double length;               ///< metres
  std::vector<int32_t> nodes;  ///< of the graph, from a to b, both included

  int32_t other(int32_t vertex) const { return vertex == a ? b : a; }
};

/// What is left of a graph when only its ends and branching nodes count as vertices.
struct TreeChains {
  std::vector<int32_t> vertices;  ///< nodes of the graph; the first one is the graph's root
  std::vector<TreeChain> chains;

  int degree(int32_t vertex) const;
};

/// \param loops whether the edges that close loops belong to it; without them it is a tree
TreeChains makeChains(const TreeGraph& graph, bool loops);

/// Removes one chain and joins what hung together at its ends only by way of it.
void removeChain(size_t chain, TreeChains* chains);

/// Removes ends' chains that are shorter than `least` metres, the shortest first (Algorithm 3, step
/// 2). \param keep_root whether the root is an end like any other
void pruneChains(double least, bool keep_root, TreeChains* chains);

}  // namespace markerless_mocap
