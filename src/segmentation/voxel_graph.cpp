#include "markerless_mocap/segmentation/voxel_graph.h"

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>

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
  std::sort(order.begin(), order.end(),
            [&](uint32_t a, uint32_t b) { return hull.voxels[a].index < hull.voxels[b].index; });
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

WeightedGraph faceGraph(const VisualHull& hull, const std::vector<uint32_t>& voxels,
                        const NodeGrid& grid, bool use_color_votes) {
  WeightedGraph graph;
  graph.row_start.reserve(voxels.size() + 1);
  graph.neighbor.reserve(voxels.size() * 6);
  graph.weight.reserve(voxels.size() * 6);
  for (uint32_t node = 0; node < voxels.size(); ++node) {
    for (int side = 0; side < 6; ++side) {
      const int axis = side / 2;
      const int step = side % 2 == 0 ? -1 : 1;
      const int32_t next =
          grid.neighbor(node, axis == 0 ? step : 0, axis == 1 ? step : 0, axis == 2 ? step : 0);
      if (next < 0) continue;
      graph.neighbor.push_back(uint32_t(next));
      graph.weight.push_back(
          edgeWeight(hull, voxels[step > 0 ? node : uint32_t(next)], axis, use_color_votes));
    }
    graph.row_start.push_back(uint32_t(graph.neighbor.size()));
  }
  return graph;
}

std::vector<double> depthUnderSurface(const VoxelGraph& voxels) {
  std::vector<uint32_t> surface;
  for (uint32_t node = 0; node < voxels.graph.nodeCount(); ++node) {
    if (voxels.graph.row_start[node + 1] - voxels.graph.row_start[node] < 6)
      surface.push_back(node);
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
  const std::vector<uint32_t> all = voxelsByIndex(hull);
  const WeightedGraph whole = faceGraph(hull, all, NodeGrid(cellsOf(hull, all)), use_color_votes);
  const std::vector<uint32_t> kept = largestComponent(whole);
  for (uint32_t i = 0, next = 0; i < all.size(); ++i) {
    const bool keep = next < kept.size() && kept[next] == i;
    (keep ? voxels.hull_voxel : voxels.left_out).push_back(all[i]);
    if (keep) ++next;
  }
  voxels.graph = subgraph(whole, kept);
  voxels.grid = NodeGrid(cellsOf(hull, voxels.hull_voxel));
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
