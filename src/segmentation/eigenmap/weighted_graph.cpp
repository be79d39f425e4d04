#include "segmentation/weighted_graph.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace markerless_mocap {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

}  // namespace

WeightedGraph graphOfEdges(size_t nodes, const std::vector<Edge>& edges) {
  WeightedGraph graph;
  graph.row_start.assign(nodes + 1, 0);
  for (const Edge& edge : edges) {
    ++graph.row_start[edge.from + 1];
    ++graph.row_start[edge.to + 1];
  }
  std::partial_sum(graph.row_start.begin(), graph.row_start.end(), graph.row_start.begin());
  graph.neighbor.resize(edges.size() * 2);
  graph.weight.resize(edges.size() * 2);
  std::vector<uint32_t> next(graph.row_start.begin(), graph.row_start.end() - 1);
  const auto put = [&](uint32_t from, uint32_t to, double weight) {
    graph.neighbor[next[from]] = to;
    graph.weight[next[from]++] = weight;
  };
  for (const Edge& edge : edges) {
    put(edge.from, edge.to, edge.weight);
    put(edge.to, edge.from, edge.weight);
  }
  return graph;
}

std::vector<uint32_t> allNodesOf(const WeightedGraph& graph) {
  std::vector<uint32_t> nodes(graph.nodeCount());
  std::iota(nodes.begin(), nodes.end(), 0u);
  return nodes;
}

std::vector<uint32_t> connectedComponents(const std::vector<uint32_t>& row_start,
                                          const std::vector<uint32_t>& neighbor) {
  std::vector<uint32_t> component(row_start.size() - 1, kNone);
  std::vector<uint32_t> open;
  uint32_t count = 0;
  for (uint32_t seed = 0; seed < component.size(); ++seed) {
    if (component[seed] != kNone) continue;
    component[seed] = count;
    open.assign(1, seed);
    while (!open.empty()) {
      const uint32_t node = open.back();
      open.pop_back();
      for (uint32_t e = row_start[node]; e < row_start[node + 1]; ++e) {
        if (component[neighbor[e]] != kNone) continue;
        component[neighbor[e]] = count;
        open.push_back(neighbor[e]);
      }
    }
    ++count;
  }
  return component;
}

uint32_t mostFrequent(const std::vector<uint32_t>& numbers) {
  std::vector<uint32_t> counts;
  for (const uint32_t number : numbers) {
    if (number >= counts.size()) counts.resize(number + 1, 0);
    ++counts[number];
  }
  return uint32_t(std::max_element(counts.begin(), counts.end()) - counts.begin());
}

}  // namespace markerless_mocap
