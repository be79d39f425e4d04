#include "markerless_mocap/segmentation/weighted_graph.h"

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

std::vector<uint32_t> connectedComponents(const WeightedGraph& graph) {
  std::vector<uint32_t> component(graph.nodeCount(), kNone);
  std::vector<uint32_t> open;
  uint32_t count = 0;
  for (uint32_t seed = 0; seed < component.size(); ++seed) {
    if (component[seed] != kNone) continue;
    component[seed] = count;
    open.assign(1, seed);
    while (!open.empty()) {
      const uint32_t node = open.back();
      open.pop_back();
      for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
        if (component[graph.neighbor[e]] != kNone) continue;
        component[graph.neighbor[e]] = count;
        open.push_back(graph.neighbor[e]);
      }
    }
    ++count;
  }
  return component;
}

std::vector<uint32_t> largestComponent(const WeightedGraph& graph) {
  const std::vector<uint32_t> component = connectedComponents(graph);
  std::vector<uint32_t> sizes;
  for (const uint32_t c : component) {
    if (c >= sizes.size()) sizes.resize(c + 1, 0);
    ++sizes[c];
  }
  std::vector<uint32_t> nodes;
  if (sizes.empty()) return nodes;
  const auto largest = uint32_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  for (uint32_t node = 0; node < component.size(); ++node) {
    if (component[node] == largest) nodes.push_back(node);
  }
  return nodes;
}

WeightedGraph subgraph(const WeightedGraph& graph, const std::vector<uint32_t>& nodes) {
  std::vector<uint32_t> place(graph.nodeCount(), kNone);
  for (uint32_t i = 0; i < nodes.size(); ++i) place[nodes[i]] = i;
  WeightedGraph part;
  part.row_start.reserve(nodes.size() + 1);
  if (!graph.cell.empty()) part.cell.reserve(nodes.size());
  for (const uint32_t node : nodes) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      if (place[graph.neighbor[e]] == kNone) continue;
      part.neighbor.push_back(place[graph.neighbor[e]]);
      part.weight.push_back(graph.weight[e]);
    }
    part.row_start.push_back(uint32_t(part.neighbor.size()));
    if (!graph.cell.empty()) part.cell.push_back(graph.cell[node]);
  }
  return part;
}

}  // namespace markerless_mocap
