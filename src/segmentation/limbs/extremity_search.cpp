#include "segmentation/limbs/extremity_search.h"

#include <Eigen/Core>
#include <cmath>
#include <optional>
#include <utility>

#include "segmentation/eigenmap.h"
#include "segmentation/graph_modes.h"
#include "segmentation/limbs/merge_tree.h"

namespace markerless_mocap {
namespace {

constexpr double kResidual = 0.15;  // of the modes; changes the label of one voxel in ten thousand
/// A body at a pitch of 25 mm; a finer pitch does not change the extremities.
constexpr size_t kEnoughNodes = 6000;

/// The embedding of the hull's graph, or of the graph of its blocks.
struct Embedding {
  Adjacency graph;
  Eigenmap map;
  std::vector<uint32_t> block;  ///< embedded node to which each voxel's node belongs
};

std::optional<Embedding> embedBlocks(const WeightedGraph& graph, int modes) {
  const std::vector<uint32_t> nodes = allNodesOf(graph);
  BlockGraph blocks =
      nodes.size() > kEnoughNodes ? gatherBlocks(graph, nodes) : gatherNodes(graph, nodes);
  Embedding embedding{{}, {}, std::move(blocks.block)};
  std::vector<GraphLevel> levels = hierarchyForModes(std::move(blocks), modes);
  auto finest = levels.begin();
  for (; finest->nodeCount() > kEnoughNodes && !finest->parent.empty(); ++finest) {
    for (uint32_t& block : embedding.block) block = finest->parent[block];
  }
  levels.erase(levels.begin(), finest);
  if (levels.size() == 1) return {};
  std::optional<GraphModes> found = coarseToFineModes(levels, modes, kResidual);
  if (!found) return {};
  embedding.map = {std::move(found->values), std::move(found->vectors), {}};
  embedding.graph = {std::move(levels[0].row_start), std::move(levels[0].neighbor)};
  return embedding;
}

Embedding embed(const WeightedGraph& graph, int modes) {
  std::optional<Embedding> blocks = embedBlocks(graph, modes);
  if (blocks) return *std::move(blocks);
  return {{graph.row_start, graph.neighbor},
          laplacianEigenmap(graph, modes, kResidual),
          allNodesOf(graph)};
}

}  // namespace

std::vector<uint32_t> findExtremities(const VoxelGraph& voxels, const std::vector<uint32_t>& core,
                                      int modes, int count) {
  const Embedding embedding = embed(voxels.graph, modes);
  std::vector<uint32_t> core_blocks;
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const uint32_t node : core) {
    core_blocks.push_back(embedding.block[node]);
    middle += voxels.centers[node] / double(core.size());
  }
  const std::vector<uint32_t> blocks =
      persistentMaxima(embedding.graph, distanceFromCore(embedding.map, core_blocks), count);
  std::vector<uint32_t> extremities(blocks.size());
  std::vector<double> farthest(blocks.size(), -1.0);
  for (uint32_t node = 0; node < embedding.block.size(); ++node) {
    for (size_t i = 0; i < blocks.size(); ++i) {
      if (embedding.block[node] != blocks[i]) continue;
      const double distance = (voxels.centers[node] - middle).squaredNorm();
      if (distance <= farthest[i]) continue;
      farthest[i] = distance;
      extremities[i] = node;
    }
  }
  return extremities;
}

}  // namespace markerless_mocap
