#include "segmentation/voxel_graph.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "numerics/disjoint_sets.h"
#include "segmentation/limbs/bridges.h"

namespace markerless_mocap {
namespace {

constexpr double kDeepest = 0.002;    // fraction of the nodes whose mean depth is the maximum depth
constexpr double kSameDegree = 1e-9;  // sums of weights differ by rounding
constexpr double kShrunkDepth = 0.75;  // of the maximum depth; thighs and head have less than 0.7

std::vector<uint32_t> voxelsByIndex(const VisualHull& hull) {
  std::vector<uint32_t> order(hull.voxels.size());
  std::iota(order.begin(), order.end(), 0u);
  const auto lower = [&](uint32_t a, uint32_t b) {
    return hull.voxels[a].index < hull.voxels[b].index;
  };
  if (!std::is_sorted(order.begin(), order.end(), lower)) {
    std::sort(order.begin(), order.end(), lower);
  }
  return order;
}

std::vector<Eigen::Vector3i> cellsOf(const VisualHull& hull, const std::vector<uint32_t>& voxels) {
  std::vector<Eigen::Vector3i> cells;
  cells.reserve(voxels.size());
  for (const uint32_t v : voxels) cells.push_back(hull.lattice.coordinates(hull.voxels[v].index));
  return cells;
}

/// The colour votes of two neighbours are stored at the voxel with the smaller coordinates.
double edgeWeight(const VisualHull& hull, uint32_t lower, int axis, const EdgeWeights& weights) {
  if (!weights.use_color_votes) return 1.0;
  const ColorVotes& votes = hull.voxels[lower].color_votes;
  return 1.0 + colorBonus(votes.votes[axis], votes.possible[axis], weights.color_bonus);
}

/// Removes all nodes outside the largest component; components that touch by an edge or corner are
/// joined.
/// \return the bridge edges between the remaining components
std::vector<Edge> keepLargestComponent(const VisualHull& hull, VoxelGraph* voxels) {
  const std::vector<uint32_t> component = faceComponents(voxels->grid);
  if (std::all_of(component.begin(), component.end(), [](uint32_t c) { return c == 0; })) return {};
  std::vector<Edge> bridges = bridgeEdges(voxels->grid, component);
  std::vector<uint32_t> joined(component.size());  // joined component of each 6-connected component
  std::iota(joined.begin(), joined.end(), 0u);
  for (const Edge& bridge : bridges)
    joinSets(&joined, component[bridge.from], component[bridge.to]);
  std::vector<uint32_t> joined_of;
  for (const uint32_t c : component) joined_of.push_back(rootOf(&joined, c));
  const uint32_t largest = mostFrequent(joined_of);
  const std::vector<uint32_t> all = std::move(voxels->hull_voxel);
  std::vector<uint32_t> number;
  voxels->hull_voxel.clear();
  for (size_t node = 0; node < all.size(); ++node) {
    number.push_back(uint32_t(voxels->hull_voxel.size()));
    (joined_of[node] == largest ? voxels->hull_voxel : voxels->left_out).push_back(all[node]);
  }
  if (voxels->left_out.empty()) return bridges;
  voxels->grid = NodeGrid(cellsOf(hull, voxels->hull_voxel));
  std::vector<Edge> kept;
  for (const Edge& bridge : bridges)
    if (joined_of[bridge.from] == largest)
      kept.push_back({number[bridge.from], number[bridge.to], bridge.weight});
  return kept;
}

/// Both directions of each edge, sorted by their start.
std::vector<Edge> fromBothEnds(std::vector<Edge> edges) {
  const size_t count = edges.size();
  for (size_t i = 0; i < count; ++i) edges.push_back({edges[i].to, edges[i].from, edges[i].weight});
  std::sort(edges.begin(), edges.end(), [](const Edge& a, const Edge& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  });
  return edges;
}

/// The graph's rows: face neighbours in ascending order, then bridges.
WeightedGraph graphOf(const VisualHull& hull, const VoxelGraph& voxels,
                      const std::vector<Edge>& bridges, const EdgeWeights& weights) {
  const size_t nodes = voxels.hull_voxel.size();
  WeightedGraph graph;
  graph.row_start.reserve(nodes + 1);
  graph.neighbor.reserve(6 * nodes);
  graph.weight.reserve(6 * nodes);
  const auto join = [&](uint32_t other, double weight) {
    graph.neighbor.push_back(other);
    graph.weight.push_back(weight);
  };
  const std::vector<Edge> across = fromBothEnds(bridges);
  auto bridge = across.begin();
  for (uint32_t node = 0; node < nodes; ++node) {
    for (int axis = 2; axis >= 0; --axis) {
      const int32_t other = voxels.grid.neighbor(node, -(axis == 0), -(axis == 1), -(axis == 2));
      if (other < 0) continue;
      join(uint32_t(other), edgeWeight(hull, voxels.hull_voxel[other], axis, weights));
    }
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t other = voxels.grid.neighbor(node, axis == 0, axis == 1, axis == 2);
      if (other < 0) continue;
      join(uint32_t(other), edgeWeight(hull, voxels.hull_voxel[node], axis, weights));
    }
    for (; bridge != across.end() && bridge->from == node; ++bridge)
      join(bridge->to, bridge->weight);
    graph.row_start.push_back(uint32_t(graph.neighbor.size()));
  }
  return graph;
}

bool isSurface(const NodeGrid& grid, uint32_t node) {
  return grid.neighbor(node, -1, 0, 0) < 0 || grid.neighbor(node, 1, 0, 0) < 0 ||
         grid.neighbor(node, 0, -1, 0) < 0 || grid.neighbor(node, 0, 1, 0) < 0 ||
         grid.neighbor(node, 0, 0, -1) < 0 || grid.neighbor(node, 0, 0, 1) < 0;
}

std::vector<double> depthUnderSurface(const VoxelGraph& voxels) {
  std::vector<uint32_t> surface;
  for (uint32_t node = 0; node < voxels.graph.nodeCount(); ++node) {
    if (isSurface(voxels.grid, node)) surface.push_back(node);
  }
  std::vector<double> depth = voxels.grid.geodesics(surface);
  for (double& d : depth) d = (d + 0.5) * voxels.pitch;
  return depth;
}

/// Nodes with at least this fraction of the largest sum of weights.
std::vector<uint32_t> nodesOfLargeDegree(const WeightedGraph& graph, double fraction) {
  std::vector<double> degree(graph.nodeCount(), 0.0);
  for (uint32_t node = 0; node < degree.size(); ++node)
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e)
      degree[node] += graph.weight[e];
  const double largest = degree.empty() ? 0.0 : *std::max_element(degree.begin(), degree.end());
  std::vector<uint32_t> nodes;
  for (uint32_t node = 0; node < degree.size(); ++node)
    if (degree[node] >= fraction * largest - kSameDegree) nodes.push_back(node);
  return nodes;
}

void raiseCoreWeights(const std::vector<uint32_t>& core_nodes, double shrink_weight,
                      WeightedGraph* raised) {
  std::vector<char> core(raised->nodeCount(), 0);
  for (const uint32_t node : core_nodes) core[node] = 1;
  WeightedGraph& graph = *raised;
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      if (core[node] || core[graph.neighbor[e]]) graph.weight[e] += shrink_weight;
    }
  }
}

}  // namespace

double colorBonus(int votes, int possible, const ColorBonus& bonus) {
  if (possible == 0) return 0.0;
  if (votes >= possible) return bonus.all;
  const double share = double(votes) / possible;
  if (share >= bonus.most_from) return bonus.most;
  return share < bonus.few_below ? bonus.few : 0.0;
}

EdgeWeights edgeWeightsOf(const SegmentationOptions& options) {
  return {options.use_color_votes, options.shrink_weight, options.shrink_degree,
          options.color_bonus};
}

VoxelGraph buildVoxelGraph(const VisualHull& hull, const EdgeWeights& weights) {
  VoxelGraph voxels;
  voxels.pitch = hull.lattice.pitch;
  voxels.hull_voxel = voxelsByIndex(hull);
  voxels.grid = NodeGrid(cellsOf(hull, voxels.hull_voxel));
  const std::vector<Edge> bridges = keepLargestComponent(hull, &voxels);
  voxels.graph = graphOf(hull, voxels, bridges, weights);
  for (const Eigen::Vector3i& c : cellsOf(hull, voxels.hull_voxel))
    voxels.graph.cell.emplace_back(c.x(), c.y(), c.z());
  voxels.centers.reserve(voxels.hull_voxel.size());
  for (const uint32_t v : voxels.hull_voxel) {
    voxels.centers.push_back(hull.lattice.center(hull.voxels[v].index));
  }
  voxels.depth = depthUnderSurface(voxels);
  if (weights.shrink_weight > 0.0)
    raiseCoreWeights(weights.shrink_degree > 0.0
                         ? nodesOfLargeDegree(voxels.graph, weights.shrink_degree)
                         : coreNodes(voxels.depth, kShrunkDepth),
                     weights.shrink_weight, &voxels.graph);
  return voxels;
}

std::vector<uint32_t> coreNodes(const std::vector<double>& depth, double fraction) {
  if (depth.empty()) return {};
  std::vector<double> deepest = depth;
  const auto count = std::max<size_t>(1, size_t(kDeepest * double(depth.size())));
  std::partial_sort(deepest.begin(), deepest.begin() + count, deepest.end(), std::greater<>());
  const double top = std::accumulate(deepest.begin(), deepest.begin() + count, 0.0) / double(count);
  std::vector<uint32_t> core;
  for (uint32_t node = 0; node < depth.size(); ++node) {
    if (depth[node] >= fraction * top) core.push_back(node);
  }
  return core;
}

}  // namespace markerless_mocap
