#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Undirected weighted graph in compressed rows. Each edge stands in the rows of both its ends with
/// the same weight; weights are > 0; no node is its own neighbour.
struct WeightedGraph {
  std::vector<uint32_t> row_start{0};  ///< node i's edges are [row_start[i], row_start[i + 1])
  std::vector<uint32_t> neighbor;
  std::vector<double> weight;

  size_t nodeCount() const { return row_start.size() - 1; }
};

struct Edge {
  uint32_t from;
  uint32_t to;
  double weight;
};

/// \param edges each pair of nodes at most once, in either direction
WeightedGraph graphOfEdges(size_t nodes, const std::vector<Edge>& edges);

/// Connected component of each node, numbered from 0 in the order of their lowest node.
std::vector<uint32_t> connectedComponents(const WeightedGraph& graph);

/// Nodes of the component with most nodes (the first of equals), ascending; empty for no graph.
std::vector<uint32_t> largestComponent(const WeightedGraph& graph);

/// The graph on `nodes` (distinct) alone; its node i is nodes[i].
WeightedGraph subgraph(const WeightedGraph& graph, const std::vector<uint32_t>& nodes);

}  // namespace markerless_mocap
