#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/weighted_graph.h"

namespace markerless_mocap {

/// One graph of a hierarchy, in single precision: that of its edges and of its nodes' masses.
struct GraphLevel {
  std::vector<uint32_t> row_start;  ///< as WeightedGraph
  std::vector<uint32_t> neighbor;
  std::vector<float> weight;
  std::vector<float> mass;              ///< sum of the weights of the finest edges at its nodes
  std::vector<float> inverse_diagonal;  ///< 1 / sum of the node's weights
  std::vector<uint32_t> parent;         ///< node of the next coarser level; empty on the coarsest

  size_t nodeCount() const { return mass.size(); }
};

/// Some nodes of a graph on a lattice, gathered in a graph of fewer.
struct BlockGraph {
  GraphLevel level;
  std::vector<LatticeCell> cell;  ///< of each of the level's nodes
  std::vector<uint32_t> block;    ///< the level's node that each of the nodes belongs to
};

/// Each of some nodes by itself, with the edges between them.
/// \param graph with cells
/// \param nodes distinct, ascending
BlockGraph gatherNodes(const WeightedGraph& graph, const std::vector<uint32_t>& nodes);

/// Those in a block of 2 x 2 x 2 cells that are connected inside it become one, with the weights of
/// all edges between two blocks summed (Galerkin's product with piecewise constant functions). So
/// limbs that pass by each other stay apart.
BlockGraph gatherBlocks(const WeightedGraph& graph, const std::vector<uint32_t>& nodes);

/// Ever coarser graphs, the given one first, each gathered in blocks of the one before.
/// \param finest connected
/// \param least nodes of every level
/// \param enough coarsening ends at so few nodes, or where it hardly shrinks the graph
std::vector<GraphLevel> buildHierarchy(BlockGraph finest, size_t least, size_t enough);

}  // namespace markerless_mocap
