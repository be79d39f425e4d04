#include "skeleton/labelling/extremity_candidates.h"

#include <algorithm>

#include "skeleton/graph/tree_metric.h"

namespace markerless_mocap {
namespace {

constexpr double kEndLength = 0.10, kLimbLength = 0.30;  // metres from the end
constexpr double kProbe = 0.03;                          // metres between two samples of the radius

/// Path lengths between `nodes` along the tree, row by row.
std::vector<double> treePathLengths(const TreeGraph& graph, const std::vector<int32_t>& nodes) {
  std::vector<double> out;
  out.reserve(nodes.size() * nodes.size());
  for (const int32_t from : nodes) {
    const std::vector<double> path_lengths = treePathLengthsFrom(graph, from);
    for (const int32_t to : nodes) out.push_back(path_lengths[size_t(to)]);
  }
  return out;
}

/// Shortens the path lengths between the nodes by the edges that close loops. Node `extremities + 2
/// i` is the first node of edge i, the next one its second.
void relaxOverLoopEdges(const TreeGraph& graph, size_t extremities, size_t count,
                        std::vector<double>* path_lengths) {
  for (size_t i = 0; i < graph.loop_edges.size(); ++i) {
    const size_t a = extremities + 2 * i, b = a + 1;
    const double length = graph.loop_edges[i].length;
    if ((*path_lengths)[a * count + b] <= length) continue;
    for (size_t u = 0; u < count; ++u) {
      const double to_b = (*path_lengths)[u * count + a] + length,
                   to_a = (*path_lengths)[u * count + b] + length;
      for (size_t v = 0; v < count; ++v) {
        double& path_length = (*path_lengths)[u * count + v];
        path_length = std::min({path_length, to_b + (*path_lengths)[b * count + v],
                                to_a + (*path_lengths)[a * count + v]});
      }
    }
  }
}

/// Nodes from an end towards the next branching and on towards the root, up to `max_length` metres.
std::vector<int32_t> pathFrom(const TreeGraph& graph, const TreeChain& chain, bool from_a,
                              double max_length) {
  std::vector<int32_t> path(chain.nodes);
  if (!from_a) std::reverse(path.begin(), path.end());
  double path_length = 0.0;
  for (size_t i = 1; i < path.size(); ++i) {
    path_length += (graph.positions[size_t(path[i])] - graph.positions[size_t(path[i - 1])]).norm();
    if (path_length > max_length) {
      path.resize(i);
      break;
    }
  }
  return path;
}

ExtremityCandidate describe(const TreeGraph& graph, const TreeVolume& volume,
                            const std::vector<int32_t>& path, double branch) {
  ExtremityCandidate end;
  end.node = path.front();
  end.position = graph.positions[size_t(end.node)];
  end.branch = branch;
  double path_length = 0.0, next = 0.0;
  double sums[2] = {0.0, 0.0};
  int counts[2] = {0, 0};
  int32_t back = path.back();
  bool back_known = false;
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0)
      path_length +=
          (graph.positions[size_t(path[i])] - graph.positions[size_t(path[i - 1])]).norm();
    if (!back_known && path_length >= kEndLength) {
      back = path[i];
      back_known = true;
    }
    if (path_length < next) continue;
    next += kProbe;
    const int part = path_length > kEndLength;
    sums[part] += volume.thickness(graph.voxels[size_t(path[i])]);
    ++counts[part];
  }
  end.end_radius = sums[0] / counts[0];
  end.limb_radius = counts[1] > 0 ? sums[1] / counts[1] : end.end_radius;
  end.direction = (end.position - graph.positions[size_t(back)]).stableNormalized();
  for (const TreeLinks::Edge& edge : graph.loop_edges)
    end.cut |= edge.a == end.node || edge.b == end.node;
  if (!end.cut) end.extent = volume.distanceToSurface(end.position, end.direction, 0.2);
  return end;
}

}  // namespace

ExtremityCandidates findExtremityCandidates(const TreeGraph& graph, const TreeVolume& volume,
                                            double prune_ratio, size_t max_length) {
  ExtremityCandidates out;
  TreeChains tree = makeChains(graph);
  out.longest = longestPathLength(graph);
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
  if (branches.size() > max_length) branches.resize(max_length);
  std::vector<int32_t> nodes;
  for (const Branch& branch : branches) {
    const TreeChain& chain = *branch.chain;
    out.extremities.push_back(
        describe(graph, volume, pathFrom(graph, chain, branch.from_a, kLimbLength), chain.length));
    nodes.push_back(out.extremities.back().node);
  }
  for (const TreeLinks::Edge& edge : graph.loop_edges) {
    nodes.push_back(edge.a);
    nodes.push_back(edge.b);
  }
  std::vector<double> path_lengths = treePathLengths(graph, nodes);
  const auto endsOnly = [&](std::vector<double>* to) {
    for (size_t a = 0; a < out.extremities.size(); ++a)
      for (size_t b = 0; b < out.extremities.size(); ++b)
        to->push_back(path_lengths[a * nodes.size() + b]);
  };
  endsOnly(&out.tree_path_lengths);
  relaxOverLoopEdges(graph, out.extremities.size(), nodes.size(), &path_lengths);
  endsOnly(&out.shortest_path_lengths);
  return out;
}

}  // namespace markerless_mocap
