#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// One graph of a hierarchy, with weights and masses in single precision.
struct GraphLevel {
  std::vector<uint32_t> row_start;  ///< as WeightedGraph
  std::vector<uint32_t> neighbor;
  std::vector<float> weight;
  std::vector<float> mass;              ///< sum of the weights of the finest edges at its nodes
  std::vector<float> inverse_diagonal;  ///< 1 / sum of the node's weights
  std::vector<uint32_t> parent;         ///< node of the next coarser level; empty on the coarsest

  size_t nodeCount() const { return mass.size(); }
};

/// A subgraph of a graph on a lattice, possibly with several nodes merged into one.
struct BlockGraph {
  GraphLevel level;
  std::vector<LatticeCell> cell;  ///< cell of each of the level's nodes
  std::vector<uint32_t> block;    ///< the level's node to which each of the given nodes belongs
};

/// The subgraph of some nodes, without merging.
/// \param graph with cells
/// \param nodes distinct, ascending
BlockGraph gatherNodes(const WeightedGraph& graph, const std::vector<uint32_t>& nodes);

/// Merges nodes in a block of 2 x 2 x 2 cells that are connected inside the block. The weights of
/// all edges between two merged nodes are summed (Galerkin product with piecewise constant
/// functions). Limbs that only pass each other are not merged.
BlockGraph gatherBlocks(const WeightedGraph& graph, const std::vector<uint32_t>& nodes);

/// A hierarchy of graphs, the given one first; each is the previous one merged in blocks.
/// \param finest connected
/// \param least minimum number of nodes of a level
/// \param enough coarsening ends at this number of nodes, or if it hardly reduces the graph
std::vector<GraphLevel> buildHierarchy(BlockGraph finest, size_t min_nodes, size_t enough);

}  // namespace markerless_mocap
