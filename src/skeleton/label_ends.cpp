#include "skeleton/label_ends.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "skeleton/tree_metric.h"

namespace markerless_mocap {
namespace {

constexpr double kTip = 0.10, kLimb = 0.30;  // metres from the end
constexpr double kProbe = 0.03;              // between two places where the radius is taken

std::vector<double> shortWaysFrom(const TreeGraph& graph,
                                  const std::vector<std::vector<TreeEdge>>& links, int32_t from) {
  std::vector<double> ways(graph.size(), std::numeric_limits<double>::infinity());
  using Item = std::pair<double, int32_t>;
  std::priority_queue<Item, std::vector<Item>, std::greater<Item>> open;
  ways[size_t(from)] = 0;
  open.push({0.0, from});
  while (!open.empty()) {
    const auto [way, at] = open.top();
    open.pop();
    if (way > ways[size_t(at)]) continue;
    for (const TreeEdge& edge : links[size_t(at)]) {
      if (way + edge.length >= ways[size_t(edge.to)]) continue;
      ways[size_t(edge.to)] = way + edge.length;
      open.push({way + edge.length, edge.to});
    }
  }
  return ways;
}

/// Nodes from an end towards the next branching and on towards the root, as far as `most` metres.
std::vector<int32_t> pathFrom(const TreeGraph& graph, const TreeChain& chain, bool from_a,
                              double most) {
  std::vector<int32_t> path(chain.nodes);
  if (!from_a) std::reverse(path.begin(), path.end());
  double way = 0.0;
  for (size_t i = 1; i < path.size(); ++i) {
    way += (graph.positions[size_t(path[i])] - graph.positions[size_t(path[i - 1])]).norm();
    if (way > most) {
      path.resize(i);
      break;
    }
  }
  return path;
}

SkeletonEnd describe(const TreeGraph& graph, const TreeVolume& volume,
                     const std::vector<int32_t>& path, double branch) {
  SkeletonEnd end;
  end.node = path.front();
  end.position = graph.positions[size_t(end.node)];
  end.branch = branch;
  double way = 0.0, next = 0.0;
  double sums[2] = {0.0, 0.0};
  int counts[2] = {0, 0};
  int32_t back = path.back();
  bool back_known = false;
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0)
      way += (graph.positions[size_t(path[i])] - graph.positions[size_t(path[i - 1])]).norm();
    if (!back_known && way >= kTip) {
      back = path[i];
      back_known = true;
    }
    if (way < next) continue;
    next += kProbe;
    const int part = way > kTip;
    sums[part] += volume.thickness(graph.voxels[size_t(path[i])]);
    ++counts[part];
  }
  end.tip_radius = sums[0] / counts[0];
  end.limb_radius = counts[1] > 0 ? sums[1] / counts[1] : end.tip_radius;
  end.direction = (end.position - graph.positions[size_t(back)]).stableNormalized();
  end.extent = volume.wayOut(end.position, end.direction, 0.2);
  for (const auto& [a, b] : graph.loop_edges) end.cut |= a == end.node || b == end.node;
  return end;
}

}  // namespace

SkeletonEnds findEnds(const TreeGraph& graph, const TreeVolume& volume, double prune_ratio,
                      size_t most) {
  SkeletonEnds out;
  TreeChains tree = makeChains(graph, false);
  out.longest = TreeMetric(tree).longest();
  pruneChains(prune_ratio * out.longest, true, &tree);
  const TreeMetric metric(tree);
  std::vector<int32_t> vertices = metric.ends();
  std::stable_sort(vertices.begin(), vertices.end(),
                   [&](int32_t a, int32_t b) { return metric.branch(a) > metric.branch(b); });
  if (vertices.size() > most) vertices.resize(most);
  std::vector<std::vector<TreeEdge>> links(graph.size());
  const auto join = [&](int32_t a, int32_t b) {
    const double length = (graph.positions[size_t(a)] - graph.positions[size_t(b)]).norm();
    links[size_t(a)].push_back({b, length});
    links[size_t(b)].push_back({a, length});
  };
  for (size_t node = 1; node < graph.size(); ++node) join(int32_t(node), graph.parents[node]);
  for (const auto& [a, b] : graph.loop_edges) join(a, b);
  for (const int32_t v : vertices) {
    for (const TreeChain& chain : tree.chains) {
      if (chain.a != v && chain.b != v) continue;
      out.ends.push_back(
          describe(graph, volume, pathFrom(graph, chain, chain.a == v, kLimb), metric.branch(v)));
      break;
    }
  }
  for (const int32_t a : vertices) {
    const std::vector<double> ways = shortWaysFrom(graph, links, tree.vertices[size_t(a)]);
    for (const int32_t b : vertices) {
      out.tree_ways.push_back(metric.way(a, b));
      out.short_ways.push_back(ways[size_t(tree.vertices[size_t(b)])]);
    }
  }
  return out;
}

}  // namespace markerless_mocap
