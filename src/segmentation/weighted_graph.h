#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Cell of a node on a lattice; coordinates are from 0 to 65535.
class LatticeCell {
 public:
  LatticeCell(int i, int j, int k)
      : packed_(uint64_t(uint16_t(i)) | uint64_t(uint16_t(j)) << 16 | uint64_t(uint16_t(k)) << 32) {
  }
  /// The cell that contains this one, on a lattice of twice the pitch.
  LatticeCell block() const { return LatticeCell((packed_ >> 1) & 0x7fff7fff7fff); }
  int i() const { return int(packed_ & 0xffff); }
  int j() const { return int(packed_ >> 16 & 0xffff); }
  int k() const { return int(packed_ >> 32); }
  /// A distinct number for each cell.
  uint64_t packed() const { return packed_; }
  bool operator==(const LatticeCell& other) const { return packed_ == other.packed_; }

 private:
  explicit LatticeCell(uint64_t packed) : packed_(packed) {}

  uint64_t packed_;
};

/// Undirected weighted graph in compressed rows. Each edge is in the rows of both its ends with the
/// same weight. Weights are > 0. No node is its own neighbour.
struct WeightedGraph {
  std::vector<uint32_t> row_start{0};  ///< node i's edges are [row_start[i], row_start[i + 1])
  std::vector<uint32_t> neighbor;
  std::vector<double> weight;
  /// Cell of each node, or empty. Edges join nearby cells. Solvers are faster if cells are given.
  std::vector<LatticeCell> cell;

  size_t nodeCount() const { return row_start.size() - 1; }
};

struct Edge {
  uint32_t from;
  uint32_t to;
  double weight;
};

/// \param edges each pair of nodes up to once, in either direction
WeightedGraph graphOfEdges(size_t nodes, const std::vector<Edge>& edges);

std::vector<uint32_t> allNodesOf(const WeightedGraph& graph);

/// Connected component of each node, numbered from 0 in the order of the components' first nodes.
/// \param row_start, neighbor as in WeightedGraph
std::vector<uint32_t> connectedComponents(const std::vector<uint32_t>& row_start,
                                          const std::vector<uint32_t>& neighbor);
inline std::vector<uint32_t> connectedComponents(const WeightedGraph& graph) {
  return connectedComponents(graph.row_start, graph.neighbor);
}

/// The most frequent number; of equally frequent ones the smallest.
/// \param numbers small numbers; not empty
uint32_t mostFrequent(const std::vector<uint32_t>& numbers);

}  // namespace markerless_mocap
