#include "skeleton/tree_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "skeleton/tree_voxels.h"

namespace markerless_mocap {
namespace {

using Edges = std::vector<std::vector<TreeEdge>>;

constexpr double kSmoothing = 0.03;  // spread along the skeleton, metres

Edges neighbourEdges(const CurveSkeleton& skeleton, const std::vector<Eigen::Vector3i>& cells) {
  const TreeVoxels table(skeleton, cells);
  Edges edges(cells.size());
  for (size_t node = 0; node < cells.size(); ++node) {
    for (int code = 14; code < 27; ++code) {  // the other half of the neighbours finds this one
      const Eigen::Vector3i step(code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1);
      const int32_t to = table.nodeAt(cells[node] + step);
      if (to < 0) continue;
      const double length = skeleton.lattice.pitch * std::sqrt(double(step.squaredNorm()));
      edges[node].push_back({to, length});
      edges[size_t(to)].push_back({int32_t(node), length});
    }
  }
  return edges;
}

/// Component of each node, counted from 0.
std::vector<int32_t> componentsOf(const Edges& edges, int32_t* count) {
  std::vector<int32_t> component(edges.size(), -1);
  std::vector<int32_t> open;
  *count = 0;
  for (size_t seed = 0; seed < edges.size(); ++seed) {
    if (component[seed] >= 0) continue;
    open.assign(1, int32_t(seed));
    component[seed] = *count;
    while (!open.empty()) {
      const int32_t node = open.back();
      open.pop_back();
      for (const TreeEdge& edge : edges[size_t(node)]) {
        if (component[size_t(edge.to)] >= 0) continue;
        component[size_t(edge.to)] = *count;
        open.push_back(edge.to);
      }
    }
    ++*count;
  }
  return component;
}

/// Joins the components to the largest one, nearest first, over gaps of at most `gap`. Returns
/// which nodes hang together then.
std::vector<bool> joinComponents(const std::vector<Eigen::Vector3d>& positions, double gap,
                                 Edges* edges) {
  int32_t count = 0;
  const std::vector<int32_t> component = componentsOf(*edges, &count);
  std::vector<int> sizes(size_t(count), 0);
  for (const int32_t c : component) ++sizes[size_t(c)];
  std::vector<bool> joined(size_t(count), false);
  if (count > 0)
    joined[size_t(std::max_element(sizes.begin(), sizes.end()) - sizes.begin())] = true;
  for (int32_t round = 1; round < count; ++round) {
    double nearest = gap;
    std::pair<size_t, size_t> ends{0, 0};
    for (size_t a = 0; a < positions.size(); ++a) {
      if (joined[size_t(component[a])]) continue;
      for (size_t b = 0; b < positions.size(); ++b) {
        if (!joined[size_t(component[b])]) continue;
        const double distance = (positions[a] - positions[b]).norm();
        if (distance >= nearest) continue;
        nearest = distance;
        ends = {a, b};
      }
    }
    if (nearest >= gap) break;
    joined[size_t(component[ends.first])] = true;
    (*edges)[ends.first].push_back({int32_t(ends.second), nearest});
    (*edges)[ends.second].push_back({int32_t(ends.first), nearest});
  }
  std::vector<bool> kept(positions.size());
  for (size_t node = 0; node < kept.size(); ++node) kept[node] = joined[size_t(component[node])];
  return kept;
}

struct Reached {
  double way;
  int32_t node;
  bool operator>(const Reached& o) const { return way != o.way ? way > o.way : node > o.node; }
};

/// Shortest paths from `root`; `order` lists the nodes as they are settled.
void walkFrom(int32_t root, const Edges& edges, std::vector<double>* ways,
              std::vector<int32_t>* parents, std::vector<int32_t>* order) {
  ways->assign(edges.size(), std::numeric_limits<double>::infinity());
  parents->assign(edges.size(), -1);
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> open;
  (*ways)[size_t(root)] = 0.0;
  open.push({0.0, root});
  while (!open.empty()) {
    const Reached at = open.top();
    open.pop();
    if (at.way > (*ways)[size_t(at.node)]) continue;
    order->push_back(at.node);
    for (const TreeEdge& edge : edges[size_t(at.node)]) {
      const double way = at.way + edge.length;
      if (way >= (*ways)[size_t(edge.to)]) continue;
      (*ways)[size_t(edge.to)] = way;
      (*parents)[size_t(edge.to)] = at.node;
      open.push({way, edge.to});
    }
  }
}

/// Whether `to` is reached from `from` within `most` metres over the tree and the kept edges.
class LoopTest {
 public:
  explicit LoopTest(const std::vector<int32_t>& parents, const std::vector<double>& ways)
      : edges_(parents.size()) {
    for (size_t node = 0; node < parents.size(); ++node)
      if (parents[node] >= 0)
        keep(int32_t(node), parents[node], ways[node] - ways[size_t(parents[node])]);
  }
  void keep(int32_t a, int32_t b, double length) {
    edges_[size_t(a)].push_back({b, length});
    edges_[size_t(b)].push_back({a, length});
  }
  bool near(int32_t from, int32_t to, double most) const { return search(from, -1, to, most); }

 private:
  bool search(int32_t at, int32_t before, int32_t to, double most) const {
    if (at == to) return true;
    for (const TreeEdge& edge : edges_[size_t(at)]) {
      if (edge.to != before && edge.length <= most && search(edge.to, at, to, most - edge.length))
        return true;
    }
    return false;
  }
  Edges edges_;
};

/// Moves the nodes to the middle of their neighbours, again and again, until steps between voxels
/// are levelled out; ends stay. So lengths do not depend on the pitch or on how a skeleton lies in
/// it.
void smoothPositions(TreeGraph* graph) {
  std::vector<Eigen::Vector3d>& at = graph->positions;
  std::vector<Eigen::Vector3d> sums(at.size());
  std::vector<int> counts(at.size());
  const auto add = [&](int32_t a, int32_t b) {
    sums[size_t(a)] += at[size_t(b)];
    sums[size_t(b)] += at[size_t(a)];
    ++counts[size_t(a)];
    ++counts[size_t(b)];
  };
  const double steps = kSmoothing / graph->pitch;
  const int rounds = std::clamp(int(std::lround(2.0 * steps * steps)), 1, 40);
  for (int round = 0; round < rounds; ++round) {
    std::fill(sums.begin(), sums.end(), Eigen::Vector3d::Zero());
    std::fill(counts.begin(), counts.end(), 0);
    for (size_t node = 1; node < at.size(); ++node) add(int32_t(node), graph->parents[node]);
    for (const auto& [a, b] : graph->loop_edges) add(a, b);
    for (size_t node = 0; node < at.size(); ++node)
      if (counts[node] > 1) at[node] = 0.5 * (at[node] + sums[node] / counts[node]);
  }
  for (size_t node = 1; node < at.size(); ++node) {
    const size_t parent = size_t(graph->parents[node]);
    graph->ways[node] = graph->ways[parent] + (at[node] - at[parent]).norm();
  }
}

}  // namespace

TreeGraph makeTreeGraph(const CurveSkeleton& skeleton, double gap, double loop_length) {
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
  Edges edges = neighbourEdges(skeleton, cells);
  const std::vector<bool> kept = joinComponents(positions, gap, &edges);
  int32_t root = -1;
  for (size_t node = 0; node < count; ++node) {
    if (kept[node] && (root < 0 || cells[node].z() > cells[size_t(root)].z())) root = int32_t(node);
  }
  std::vector<double> ways;
  std::vector<int32_t> parents, order, rank(count, -1);
  walkFrom(root, edges, &ways, &parents, &order);
  for (size_t i = 0; i < order.size(); ++i) {
    const size_t node = size_t(order[i]);
    rank[node] = int32_t(i);
    graph.voxels.push_back(skeleton.voxels[node]);
    graph.positions.push_back(positions[node]);
    graph.ways.push_back(ways[node]);
    graph.parents.push_back(parents[node] < 0 ? -1 : rank[size_t(parents[node])]);
  }

  struct Closing {
    int32_t a, b;
    double length, loop;
  };
  std::vector<Closing> closings;
  for (const int32_t node : order) {
    for (const TreeEdge& edge : edges[size_t(node)]) {
      if (rank[size_t(edge.to)] < rank[size_t(node)] || parents[size_t(edge.to)] == node) continue;
      const int32_t a = rank[size_t(node)], b = rank[size_t(edge.to)];
      closings.push_back({a, b, edge.length, graph.ways[size_t(a)] + graph.ways[size_t(b)]});
    }
  }
  LoopTest loops(graph.parents, graph.ways);
  for (const Closing& closing : closings) {
    if (loops.near(closing.a, closing.b, loop_length)) continue;
    graph.loop_edges.emplace_back(closing.a, closing.b);
    loops.keep(closing.a, closing.b, closing.length);
  }
  smoothPositions(&graph);
  return graph;
}

}  // namespace markerless_mocap
