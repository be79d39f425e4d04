#include "skeleton/graph/tree_graph.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "skeleton/graph/tree_components.h"
#include "skeleton/graph/tree_voxels.h"

namespace markerless_mocap {
namespace {

std::vector<TreeLinks::Edge> neighbourEdges(const CurveSkeleton& skeleton,
                                            const std::vector<Eigen::Vector3i>& cells) {
  const TreeVoxels table(skeleton, cells);
  std::vector<TreeLinks::Edge> edges;
  edges.reserve(2 * cells.size());
  for (size_t node = 0; node < cells.size(); ++node) {
    for (int code = 14; code < 27; ++code) {  // the other half of the neighbours add the same edges
      const Eigen::Vector3i step(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      const int32_t to = table.nodeAt(cells[node] + step);
      if (to < 0) continue;
      edges.push_back(
          {int32_t(node), to, skeleton.lattice.pitch * std::sqrt(double(step.squaredNorm()))});
    }
  }
  return edges;
}

struct Reached {
  double path_length;
  int32_t node;
  bool operator>(const Reached& o) const {
    return path_length != o.path_length ? path_length > o.path_length : node > o.node;
  }
};

/// Shortest paths from `root`; breadth first, all steps are equally long.
struct Walk {
  std::vector<double> path_lengths;
  std::vector<int32_t> parents;
  std::vector<int32_t> order;  ///< nodes in the order in which they are settled

  Walk(int32_t root, const TreeLinks& links, bool breadth_first)
      : path_lengths(links.size(), std::numeric_limits<double>::infinity()),
        parents(links.size(), -1) {
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> open;
    path_lengths[size_t(root)] = 0.0;
    open.push({0.0, root});
    while (!open.empty()) {
      const Reached at = open.top();
      open.pop();
      if (at.path_length > path_lengths[size_t(at.node)]) continue;
      order.push_back(at.node);
      for (auto link = links.begin(at.node); link != links.end(at.node); ++link) {
        const double path_length = at.path_length + (breadth_first ? 1.0 : link->length);
        if (path_length >= path_lengths[size_t(link->to)]) continue;
        path_lengths[size_t(link->to)] = path_length;
        parents[size_t(link->to)] = at.node;
        open.push({path_length, link->to});
      }
    }
  }
};

/// Shortest paths over the tree and the loop edges found so far, up to a length of a few voxels.
class LoopFinder {
 public:
  explicit LoopFinder(TreeGraph* graph) : graph_(graph), children_(graph->size(), -1) {
    next_ = children_;
    for (size_t node = graph->size(); node-- > 1;) {
      next_[node] = children_[size_t(graph->parents[node])];
      children_[size_t(graph->parents[node])] = int32_t(node);
    }
  }

  void offer(const TreeLinks::Edge& edge, double loop_length) {
    if (!near(edge.a, -1, edge.b, loop_length)) graph_->loop_edges.push_back(edge);
  }

 private:
  bool near(int32_t at, int32_t before, int32_t to, double max_length) const {
    if (at == to) return true;
    const auto leads = [&](int32_t next, double length) {
      return next != before && length <= max_length && near(next, at, to, max_length - length);
    };
    if (at != 0 && leads(graph_->parents[size_t(at)], graph_->step(at))) return true;
    for (int32_t child = children_[size_t(at)]; child >= 0; child = next_[size_t(child)])
      if (leads(child, graph_->step(child))) return true;
    for (const TreeLinks::Edge& edge : graph_->loop_edges) {
      if (edge.a == at && leads(edge.b, edge.length)) return true;
      if (edge.b == at && leads(edge.a, edge.length)) return true;
    }
    return false;
  }

  TreeGraph* graph_;
  std::vector<int32_t> children_, next_;  ///< first child and next sibling
};

void closeLoops(const std::vector<TreeLinks::Edge>& edges, const std::vector<int32_t>& place,
                double loop_length, TreeGraph* graph) {
  std::vector<TreeLinks::Edge> closing;
  for (const TreeLinks::Edge& edge : edges) {
    const int32_t a = place[size_t(edge.a)], b = place[size_t(edge.b)];
    if (a < 0 || b < 0) continue;
    if (graph->parents[size_t(a)] != b && graph->parents[size_t(b)] != a)
      closing.push_back({std::min(a, b), std::max(a, b), edge.length});
  }
  std::sort(closing.begin(), closing.end(),
            [](const auto& x, const auto& y) { return x.a != y.a ? x.a < y.a : x.b < y.b; });
  LoopFinder finder(graph);
  for (const TreeLinks::Edge& edge : closing) finder.offer(edge, loop_length);
}

void measurePaths(TreeGraph* graph) {
  const std::vector<Eigen::Vector3d>& at = graph->positions;
  for (size_t node = 1; node < at.size(); ++node) {
    const size_t parent = size_t(graph->parents[node]);
    graph->path_lengths[node] = graph->path_lengths[parent] + (at[node] - at[parent]).norm();
  }
}

/// Moves the nodes repeatedly to the mean of their neighbours, until the steps between voxels are
/// smoothed; ends stay. Lengths then do not depend on the pitch or on the skeleton's position in
/// the lattice.
void smoothPositions(double smoothing, TreeGraph* graph) {
  std::vector<Eigen::Vector3d>& at = graph->positions;
  std::vector<Eigen::Vector3d> sums(at.size());
  std::vector<int> counts(at.size());
  const auto add = [&](int32_t a, int32_t b) {
    sums[size_t(a)] += at[size_t(b)];
    sums[size_t(b)] += at[size_t(a)];
    ++counts[size_t(a)];
    ++counts[size_t(b)];
  };
  const double steps = smoothing / graph->pitch;
  const int rounds =
      smoothing == 0.0 ? 0 : std::clamp(int(std::lround(2.0 * steps * steps)), 1, 40);
  for (int round = 0; round < rounds; ++round) {
    std::fill(sums.begin(), sums.end(), Eigen::Vector3d::Zero());
    std::fill(counts.begin(), counts.end(), 0);
    for (size_t node = 1; node < at.size(); ++node) add(int32_t(node), graph->parents[node]);
    for (const TreeLinks::Edge& edge : graph->loop_edges) add(edge.a, edge.b);
    for (size_t node = 0; node < at.size(); ++node)
      if (counts[node] > 1) at[node] = 0.5 * (at[node] + sums[node] / counts[node]);
  }
  measurePaths(graph);
  for (TreeLinks::Edge& edge : graph->loop_edges)
    edge.length = (at[size_t(edge.a)] - at[size_t(edge.b)]).norm();
}

}  // namespace

TreeGraph makeTreeGraph(const CurveSkeleton& skeleton, double gap, double loop_length,
                        const TreePaths& paths) {
  TreeGraph graph;
  graph.pitch = skeleton.lattice.pitch;
  const size_t count = skeleton.voxels.size();
  if (count == 0) return graph;
  std::vector<Eigen::Vector3i> cells;
  std::vector<Eigen::Vector3d> positions;
  for (const uint32_t voxel : skeleton.voxels) {
    cells.push_back(skeleton.lattice.coordinates(voxel));
    positions.push_back(skeleton.lattice.center(voxel));
  }
  std::vector<TreeLinks::Edge> edges = neighbourEdges(skeleton, cells);
  const std::vector<bool> kept = joinComponents(positions, gap, &edges);
  int32_t root = -1;
  for (size_t node = 0; node < count; ++node) {
    if (kept[node] && (root < 0 || cells[node].z() > cells[size_t(root)].z())) root = int32_t(node);
  }
  const Walk walk(root, TreeLinks(count, edges), paths.breadth_first);
  std::vector<int32_t> place(count, -1);
  for (size_t i = 0; i < walk.order.size(); ++i) {
    const size_t node = size_t(walk.order[i]);
    place[node] = int32_t(i);
    graph.voxels.push_back(skeleton.voxels[node]);
    graph.positions.push_back(positions[node]);
    graph.path_lengths.push_back(walk.path_lengths[node]);
    graph.parents.push_back(walk.parents[node] < 0 ? -1 : place[size_t(walk.parents[node])]);
  }
  if (paths.breadth_first) measurePaths(&graph);
  closeLoops(edges, place, loop_length, &graph);
  smoothPositions(paths.smoothing, &graph);
  return graph;
}

std::vector<double> treePathLengthsFrom(const TreeGraph& graph, int32_t node) {
  std::vector<double> path_lengths(graph.size(), -1.0);
  double path_length = 0.0;
  for (int32_t at = node; at >= 0; at = graph.parents[size_t(at)]) {
    path_lengths[size_t(at)] = path_length;
    if (at > 0) path_length += graph.step(at);
  }
  for (size_t at = 1; at < graph.size(); ++at)
    if (path_lengths[at] < 0.0)
      path_lengths[at] = path_lengths[size_t(graph.parents[at])] + graph.step(int32_t(at));
  return path_lengths;
}

}  // namespace markerless_mocap
