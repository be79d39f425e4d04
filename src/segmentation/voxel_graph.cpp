#include "markerless_mocap/segmentation/voxel_graph.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

#include "markerless_mocap/segmentation/bridges.h"

namespace markerless_mocap {
namespace {

constexpr double kAllVote = 1.0;       // a of Eq. 3-15
constexpr double kMostVote = 0.5;      // b
constexpr double kFewVote = -0.9;      // c, above -1 so that every weight stays > 0
constexpr double kDeepest = 0.002;     // share of the nodes that tell the greatest depth
constexpr double kShrunkDepth = 0.75;  // of the greatest depth; thighs and head lie under 0.7

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

/// The votes about two neighbours are kept by the one with the lower coordinates.
double edgeWeight(const VisualHull& hull, uint32_t lower, int axis, bool use_color_votes) {
  if (!use_color_votes) return 1.0;
  const ColorVotes& votes = hull.voxels[lower].color_votes;
  return 1.0 + colorBonus(votes.votes[axis], votes.possible[axis]);
}

std::vector<Edge> faceEdges(const VisualHull& hull, const std::vector<uint32_t>& voxels,
                            const NodeGrid& grid, bool use_color_votes) {
  std::vector<Edge> edges;
  edges.reserve(voxels.size() * 3);
  for (uint32_t node = 0; node < voxels.size(); ++node) {
    for (int axis = 0; axis < 3; ++axis) {
      const int32_t next = grid.neighbor(node, axis == 0, axis == 1, axis == 2);
      if (next < 0) continue;
      edges.push_back(
          {node, uint32_t(next), edgeWeight(hull, voxels[node], axis, use_color_votes)});
    }
  }
  return edges;
}

/// Of all voxels, with bridges if faces alone do not join them.
WeightedGraph wholeGraph(const VisualHull& hull, const VoxelGraph& voxels, bool use_color_votes,
                         bool* joined) {
  std::vector<Edge> edges = faceEdges(hull, voxels.hull_voxel, voxels.grid, use_color_votes);
  WeightedGraph graph = graphOfEdges(voxels.hull_voxel.size(), edges);
  const std::vector<uint32_t> component = connectedComponents(graph);
  *joined = std::all_of(component.begin(), component.end(), [](uint32_t c) { return c == 0; });
  if (*joined) return graph;
  const std::vector<Edge> bridges = bridgeEdges(voxels.grid, component);
  edges.insert(edges.end(), bridges.begin(), bridges.end());
  return graphOfEdges(voxels.hull_voxel.size(), edges);
}

void keepLargestComponent(const VisualHull& hull, VoxelGraph* voxels) {
  const std::vector<uint32_t> all = std::move(voxels->hull_voxel);
  const std::vector<uint32_t> kept = largestComponent(voxels->graph);
  voxels->hull_voxel.clear();
  for (uint32_t i = 0, next = 0; i < all.size(); ++i) {
    const bool keep = next < kept.size() && kept[next] == i;
    (keep ? voxels->hull_voxel : voxels->left_out).push_back(all[i]);
    if (keep) ++next;
  }
  if (voxels->left_out.empty()) return;
  voxels->graph = subgraph(voxels->graph, kept);
  voxels->grid = NodeGrid(cellsOf(hull, voxels->hull_voxel));
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

void raiseCoreWeights(VoxelGraph* voxels, double shrink_weight) {
  std::vector<char> core(voxels->graph.nodeCount(), 0);
  for (const uint32_t node : coreNodes(voxels->depth, kShrunkDepth)) core[node] = 1;
  WeightedGraph& graph = voxels->graph;
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      if (core[node] || core[graph.neighbor[e]]) graph.weight[e] += shrink_weight;
    }
  }
}

}  // namespace

double colorBonus(int votes, int possible) {
  if (possible == 0) return 0.0;
  if (votes >= possible) return kAllVote;
  return 2 * votes >= possible ? kMostVote : kFewVote;
}

VoxelGraph buildVoxelGraph(const VisualHull& hull, bool use_color_votes, double shrink_weight) {
  VoxelGraph voxels;
  voxels.pitch = hull.lattice.pitch;
  voxels.hull_voxel = voxelsByIndex(hull);
  const std::vector<Eigen::Vector3i> cells = cellsOf(hull, voxels.hull_voxel);
  voxels.grid = NodeGrid(cells);
  bool joined = false;
  voxels.graph = wholeGraph(hull, voxels, use_color_votes, &joined);
  for (const Eigen::Vector3i& c : cells) voxels.graph.cell.emplace_back(c.x(), c.y(), c.z());
  if (!joined) keepLargestComponent(hull, &voxels);
  voxels.centers.reserve(voxels.hull_voxel.size());
  for (const uint32_t v : voxels.hull_voxel) {
    voxels.centers.push_back(hull.lattice.center(hull.voxels[v].index));
  }
  voxels.depth = depthUnderSurface(voxels);
  if (shrink_weight > 0.0) raiseCoreWeights(&voxels, shrink_weight);
  return voxels;
}

std::vector<uint32_t> coreNodes(const std::vector<double>& depth, double share) {
  if (depth.empty()) return {};
  std::vector<double> deepest = depth;
  const auto count = std::max<size_t>(1, size_t(kDeepest * double(depth.size())));
  std::partial_sort(deepest.begin(), deepest.begin() + count, deepest.end(), std::greater<>());
  const double top = std::accumulate(deepest.begin(), deepest.begin() + count, 0.0) / double(count);
  std::vector<uint32_t> core;
  for (uint32_t node = 0; node < depth.size(); ++node) {
    if (depth[node] >= share * top) core.push_back(node);
  }
  return core;
}

}  // namespace markerless_mocap
