#include "markerless_mocap/segmentation/graph_hierarchy.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace markerless_mocap {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();
constexpr double kLeastShrinkage = 0.7;  // of the nodes: a level that keeps more is not worth it

uint32_t rootOf(std::vector<uint32_t>* parent, uint32_t node) {
  while ((*parent)[node] != node) {
    (*parent)[node] = (*parent)[(*parent)[node]];
    node = (*parent)[node];
  }
  return node;
}

/// Sets the level's parents, numbered in the order of their first child; returns their cells.
std::vector<LatticeCell> aggregate(const std::vector<LatticeCell>& cells, GraphLevel* level) {
  std::vector<LatticeCell> block;
  block.reserve(cells.size());
  for (const LatticeCell& cell : cells) block.push_back(cell.block());
  std::vector<uint32_t>& parent = level->parent;
  parent.resize(cells.size());
  for (uint32_t node = 0; node < cells.size(); ++node) {
    parent[node] = node;
    for (uint32_t e = level->row_start[node]; e < level->row_start[node + 1]; ++e) {
      const uint32_t other = level->neighbor[e];
      if (other > node || !(block[other] == block[node])) continue;
      const uint32_t a = rootOf(&parent, other);
      const uint32_t b = rootOf(&parent, node);
      parent[std::max(a, b)] = std::min(a, b);
    }
  }
  std::vector<LatticeCell> coarse;
  for (uint32_t node = 0; node < cells.size(); ++node) {
    if (parent[node] == node) {
      parent[node] = uint32_t(coarse.size());
      coarse.push_back(block[node]);
    } else {
      parent[node] = parent[parent[node]];  // a lower node, that has its number already
    }
  }
  return coarse;
}

GraphLevel finest(const WeightedGraph& graph) {
  GraphLevel level;
  level.row_start = graph.row_start;
  level.neighbor = graph.neighbor;
  level.weight.assign(graph.weight.begin(), graph.weight.end());
  level.mass.resize(graph.nodeCount());
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    level.mass[node] = std::accumulate(level.weight.begin() + level.row_start[node],
                                       level.weight.begin() + level.row_start[node + 1], 0.0f);
  }
  return level;
}

/// Nodes of each parent: those of parent p are children[first[p]] to children[first[p + 1] - 1].
struct Children {
  std::vector<uint32_t> first;
  std::vector<uint32_t> children;
};

Children childrenOf(const std::vector<uint32_t>& parent, size_t parents) {
  Children sorted{std::vector<uint32_t>(parents + 1, 0), std::vector<uint32_t>(parent.size())};
  for (const uint32_t p : parent) ++sorted.first[p + 1];
  std::partial_sum(sorted.first.begin(), sorted.first.end(), sorted.first.begin());
  std::vector<uint32_t> next(sorted.first.begin(), sorted.first.end() - 1);
  for (uint32_t node = 0; node < parent.size(); ++node) {
    sorted.children[next[parent[node]]++] = node;
  }
  return sorted;
}

GraphLevel coarsen(const GraphLevel& fine, size_t parents) {
  const Children sorted = childrenOf(fine.parent, parents);
  GraphLevel coarse;
  coarse.row_start.assign(1, 0);
  coarse.mass.assign(parents, 0.0f);
  std::vector<uint32_t> place(parents, kNone);  // of the edge to each parent, if in this row
  for (uint32_t p = 0; p < parents; ++p) {
    const auto row = uint32_t(coarse.neighbor.size());
    for (uint32_t c = sorted.first[p]; c < sorted.first[p + 1]; ++c) {
      const uint32_t node = sorted.children[c];
      coarse.mass[p] += fine.mass[node];
      for (uint32_t e = fine.row_start[node]; e < fine.row_start[node + 1]; ++e) {
        const uint32_t other = fine.parent[fine.neighbor[e]];
        if (other == p) continue;
        if (place[other] == kNone || place[other] < row) {
          place[other] = uint32_t(coarse.neighbor.size());
          coarse.neighbor.push_back(other);
          coarse.weight.push_back(0.0f);
        }
        coarse.weight[place[other]] += fine.weight[e];
      }
    }
    coarse.row_start.push_back(uint32_t(coarse.neighbor.size()));
  }
  return coarse;
}

void setDiagonal(GraphLevel* level) {
  level->inverse_diagonal.resize(level->nodeCount());
  for (uint32_t node = 0; node < level->nodeCount(); ++node) {
    float sum = 0.0f;
    for (uint32_t e = level->row_start[node]; e < level->row_start[node + 1]; ++e) {
      sum += level->weight[e];
    }
    level->inverse_diagonal[node] = sum > 0.0f ? 1.0f / sum : 0.0f;
  }
}

}  // namespace

std::vector<GraphLevel> buildHierarchy(const WeightedGraph& graph, size_t least, size_t enough) {
  std::vector<GraphLevel> levels{finest(graph)};
  std::vector<LatticeCell> cells = graph.cell;
  setDiagonal(&levels.back());
  while (levels.back().nodeCount() > enough) {
    std::vector<LatticeCell> coarse = aggregate(cells, &levels.back());
    const bool hardly = double(coarse.size()) > kLeastShrinkage * double(cells.size());
    if (hardly || coarse.size() < least) {
      levels.back().parent.clear();
      break;
    }
    levels.push_back(coarsen(levels.back(), coarse.size()));
    setDiagonal(&levels.back());
    cells = std::move(coarse);
  }
  return levels;
}

}  // namespace markerless_mocap
