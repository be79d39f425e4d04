#include "segmentation/eigenmap/graph_hierarchy.h"

#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "numerics/disjoint_sets.h"

namespace markerless_mocap {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
constexpr double kMaxShrinkage = 0.7;  // maximum fraction of nodes that a coarser level may keep

/// Joins the nodes of one block that are connected inside the block.
/// \param nodes ascending
/// \param parents output, parents of these nodes, numbered in the order of their first child; kNone
///   for all other nodes
/// \return the parents' cells
template <class Graph>
std::vector<LatticeCell> aggregate(const Graph& graph, const std::vector<LatticeCell>& cells,
                                   const std::vector<uint32_t>& nodes,
                                   std::vector<uint32_t>* parents) {
  std::vector<uint32_t>& parent = *parents;
  parent.assign(cells.size(), kNone);
  for (const uint32_t node : nodes) {
    parent[node] = node;
    const LatticeCell block = cells[node].block();
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      const uint32_t other = graph.neighbor[e];
      if (other > node || parent[other] == kNone || !(cells[other].block() == block)) continue;
      joinSets(&parent, other, node);
    }
  }
  std::vector<LatticeCell> coarse;
  for (const uint32_t node : nodes) {
    if (parent[node] == node) {
      parent[node] = uint32_t(coarse.size());
      coarse.push_back(cells[node].block());
    } else {
      // The parent has a smaller index, so it has its number already.
      parent[node] = parent[parent[node]];
    }
  }
  return coarse;
}

/// Nodes of each parent: those of parent p are children[first[p]] to children[first[p + 1] - 1].
struct Children {
  std::vector<uint32_t> first;
  std::vector<uint32_t> children;
};

Children childrenOf(const std::vector<uint32_t>& nodes, const std::vector<uint32_t>& parent,
                    size_t parents) {
  Children sorted{std::vector<uint32_t>(parents + 1, 0), std::vector<uint32_t>(nodes.size())};
  for (const uint32_t node : nodes) ++sorted.first[parent[node] + 1];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  std::vector<uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (const uint32_t node : nodes) sorted.children[next[parent[node]]++] = node;
  return sorted;
}

void endRow(uint32_t row, GraphLevel* level) {
  const float sum = std::accumulate(level->weight.begin() + row, level->weight.end(), 0.0f);
  level->inverse_diagonal.push_back(sum > 0.0f ? 1.0f / sum : 0.0f);
  level->row_start.push_back(uint32_t(level->neighbor.size()));
}

/// \param parent parent of each node, kNone for nodes that are not included
template <class Graph>
GraphLevel coarsen(const Graph& fine, const std::vector<uint32_t>& nodes,
                   const std::vector<uint32_t>& parent, size_t parents) {
  // Else the mass is the sum of the weights.
  constexpr bool kHasMass = std::is_same_v<Graph, GraphLevel>;
  const Children sorted = childrenOf(nodes, parent, parents);
  GraphLevel coarse;
  coarse.row_start.assign(1, 0);
  coarse.mass.reserve(parents);
  coarse.neighbor.reserve(fine.neighbor.size() / 2);
  coarse.weight.reserve(fine.neighbor.size() / 2);
  std::vector<int32_t> place(parents,
                             -1);  // index of the edge to each parent, if it is in this row
  for (uint32_t p = 0; p < parents; ++p) {
    const auto row = int32_t(coarse.neighbor.size());
    float mass = 0.0f;
    for (uint32_t c = sorted.first[p]; c < sorted.first[p + 1]; ++c) {
      const uint32_t node = sorted.children[c], end = fine.row_start[node + 1];
      if constexpr (kHasMass) mass += fine.mass[node];
      for (uint32_t e = fine.row_start[node]; e < end; ++e) {
        const uint32_t other = parent[fine.neighbor[e]];
        if (other == kNone) continue;
        const auto weight = float(fine.weight[e]);
        if constexpr (!kHasMass) mass += weight;
        if (other == p) continue;
        if (place[other] >= row) {
          coarse.weight[size_t(place[other])] += weight;
        } else {
          place[other] = int32_t(coarse.neighbor.size());
          coarse.neighbor.push_back(other);
          coarse.weight.push_back(weight);
        }
      }
    }
    coarse.mass.push_back(mass);
    endRow(uint32_t(row), &coarse);
  }
  return coarse;
}

}  // namespace

BlockGraph gatherNodes(const WeightedGraph& graph, const std::vector<uint32_t>& nodes) {
  BlockGraph own;
  own.block.resize(nodes.size());
  std::iota(own.block.begin(), own.block.end(), 0u);
  std::vector<uint32_t> number(graph.nodeCount(), kNone);
  for (uint32_t i = 0; i < nodes.size(); ++i) number[nodes[i]] = i;
  own.level = coarsen(graph, nodes, number, nodes.size());
  for (const uint32_t node : nodes) own.cell.push_back(graph.cell[node]);
  return own;
}

BlockGraph gatherBlocks(const WeightedGraph& graph, const std::vector<uint32_t>& nodes) {
  BlockGraph blocks;
  std::vector<uint32_t> parent;
  blocks.cell = aggregate(graph, graph.cell, nodes, &parent);
  blocks.level = coarsen(graph, nodes, parent, blocks.cell.size());
  for (const uint32_t node : nodes) blocks.block.push_back(parent[node]);
  return blocks;
}

std::vector<GraphLevel> buildHierarchy(BlockGraph finest, size_t min_nodes, size_t enough) {
  std::vector<GraphLevel> levels{std::move(finest.level)};
  std::vector<LatticeCell> cells = std::move(finest.cell);
  while (levels.back().nodeCount() > enough) {
    GraphLevel& fine = levels.back();
    std::vector<uint32_t> nodes(cells.size());
    std::iota(nodes.begin(), nodes.end(), 0u);
    std::vector<uint32_t> parent;
    std::vector<LatticeCell> coarse = aggregate(fine, cells, nodes, &parent);
    if (double(coarse.size()) > kMaxShrinkage * double(cells.size()) || coarse.size() < min_nodes)
      break;
    fine.parent = std::move(parent);
    levels.push_back(coarsen(fine, nodes, fine.parent, coarse.size()));
    cells = std::move(coarse);
  }
  return levels;
}

}  // namespace markerless_mocap
