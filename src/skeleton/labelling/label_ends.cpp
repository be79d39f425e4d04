#include "skeleton/labelling/label_ends.h"

#include <algorithm>

#include "skeleton/graph/tree_metric.h"

namespace markerless_mocap {
namespace {

constexpr double kTip = 0.10, kLimb = 0.30;  // metres from the end
constexpr double kProbe = 0.03;              // between two places where the radius is taken

/// Ways between `nodes` along the tree, row by row.
std::vector<double> treeWays(const TreeGraph& graph, const std::vector<int32_t>& nodes) {
  std::vector<double> out;
  out.reserve(nodes.size() * nodes.size());
  for (const int32_t from : nodes) {
    const std::vector<double> ways = treeWaysFrom(graph, from);
    for (const int32_t to : nodes) out.push_back(ways[size_t(to)]);
  }
  return out;
}

/// Shortens the ways between the nodes by the edges that close loops. Node `ends + 2 i` is edge i's
/// first, the one after it its second.
void takeLoops(const TreeGraph& graph, size_t ends, size_t count, std::vector<double>* ways) {
  for (size_t i = 0; i < graph.loop_edges.size(); ++i) {
    const size_t a = ends + 2 * i, b = a + 1;
    const double length = graph.loop_edges[i].length;
    if ((*ways)[a * count + b] <= length) continue;
    for (size_t u = 0; u < count; ++u) {
      const double to_b = (*ways)[u * count + a] + length, to_a = (*ways)[u * count + b] + length;
      for (size_t v = 0; v < count; ++v) {
        double& way = (*ways)[u * count + v];
        way = std::min({way, to_b + (*ways)[b * count + v], to_a + (*ways)[a * count + v]});
      }
    }
  }
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
  for (const TreeLinks::Edge& edge : graph.loop_edges)
    end.cut |= edge.a == end.node || edge.b == end.node;
  if (!end.cut) end.extent = volume.wayOut(end.position, end.direction, 0.2);
  return end;
}

}  // namespace

SkeletonEnds findEnds(const TreeGraph& graph, const TreeVolume& volume, double prune_ratio,
                      size_t most) {
  SkeletonEnds out;
  TreeChains tree = makeChains(graph);
  out.longest = longestWay(graph);
  pruneChains(prune_ratio * out.longest, &tree);
  struct Branch {
    const TreeChain* chain;
    bool from_a;
  };
  std::vector<Branch> branches;
  for (const TreeChain& chain : tree.chains) {
    if (tree.degrees[size_t(chain.a)] == 1) branches.push_back({&chain, true});
    if (tree.degrees[size_t(chain.b)] == 1) branches.push_back({&chain, false});
  }
  std::stable_sort(branches.begin(), branches.end(), [](const Branch& x, const Branch& y) {
    return x.chain->length > y.chain->length;
  });
  if (branches.size() > most) branches.resize(most);
  std::vector<int32_t> nodes;
  for (const Branch& branch : branches) {
    const TreeChain& chain = *branch.chain;
    out.ends.push_back(
        describe(graph, volume, pathFrom(graph, chain, branch.from_a, kLimb), chain.length));
    nodes.push_back(out.ends.back().node);
  }
  for (const TreeLinks::Edge& edge : graph.loop_edges) {
    nodes.push_back(edge.a);
    nodes.push_back(edge.b);
  }
  std::vector<double> ways = treeWays(graph, nodes);
  const auto endsOnly = [&](std::vector<double>* to) {
    for (size_t a = 0; a < out.ends.size(); ++a)
      for (size_t b = 0; b < out.ends.size(); ++b) to->push_back(ways[a * nodes.size() + b]);
  };
  endsOnly(&out.tree_ways);
  takeLoops(graph, out.ends.size(), nodes.size(), &ways);
  endsOnly(&out.short_ways);
  return out;
}

}  // namespace markerless_mocap
