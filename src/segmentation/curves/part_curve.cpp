#include "segmentation/curves/part_curve.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <utility>

#include "segmentation/curves/least_squares_spline.h"
#include "segmentation/eigenmap/graph_hierarchy.h"
#include "segmentation/graph_modes.h"

namespace markerless_mocap {
namespace {

constexpr int kPoints = 21;
constexpr int kSamples = 200;  // points of the curve, from which its length is measured
/// Fraction of the nodes beyond each end of a combination of modes.
constexpr double kOutside = 0.03;
constexpr size_t kMinNodes = 8;
constexpr size_t kEnoughNodes = 400;  // more nodes do not improve a curve
// Residual of the modes; low precision is enough, as combinations of modes are used.
constexpr double kResidual = 1.0;

/// A part as a graph of few nodes: blocks of voxels, each connected in itself.
struct Blocks {
  std::vector<GraphLevel> levels;  ///< the first one is the graph of the blocks
  Eigen::VectorXd count;           ///< number of voxels of each block
  Eigen::VectorXd ahead;           ///< mean over the block's voxels, as are the centres, metres
  Eigen::MatrixXd centers;

  Eigen::Index size() const { return count.size(); }
};

/// Sums the values of nodes, one row per node, over the children of each parent.
Eigen::MatrixXd sumOverChildren(const GraphLevel& level, size_t parents,
                                const Eigen::MatrixXd& values) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(Eigen::Index(parents), values.cols());
  for (size_t node = 0; node < level.parent.size(); ++node) {
    sums.row(level.parent[node]) += values.row(Eigen::Index(node));
  }
  return sums;
}

/// The part's largest component, with one node per voxel, or in blocks if it has many voxels.
/// \param nodes nodes of the part; reduced to those of the component
BlockGraph componentOf(const WeightedGraph& graph, std::vector<uint32_t>* nodes) {
  BlockGraph part =
      nodes->size() > kEnoughNodes ? gatherBlocks(graph, *nodes) : gatherNodes(graph, *nodes);
  const std::vector<uint32_t> component =
      connectedComponents(part.level.row_start, part.level.neighbor);
  if (std::all_of(component.begin(), component.end(), [](uint32_t c) { return c == 0; }))
    return part;
  std::vector<uint32_t> of_node;
  for (const uint32_t block : part.block) of_node.push_back(component[block]);
  const uint32_t largest = mostFrequent(of_node);
  std::vector<uint32_t> kept;
  for (size_t i = 0; i < nodes->size(); ++i)
    if (of_node[i] == largest) kept.push_back((*nodes)[i]);
  *nodes = std::move(kept);
  return componentOf(graph, nodes);
}

Blocks blocksOf(const VoxelGraph& voxels, BlockGraph part, const std::vector<uint32_t>& nodes,
                const std::vector<double>& ahead, int modes) {
  Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(Eigen::Index(part.cell.size()), 5);
  for (size_t i = 0; i < nodes.size(); ++i) {
    const Eigen::Vector3d& center = voxels.centers[nodes[i]];
    Eigen::Matrix<double, 1, 5> of_node;
    of_node << 1.0, ahead[nodes[i]], center.x(), center.y(), center.z();
    sums.row(part.block[i]) += of_node;
  }
  Blocks blocks;
  blocks.levels = hierarchyForModes(std::move(part), modes);
  auto finest = blocks.levels.begin();
  for (; finest->nodeCount() > kEnoughNodes && !finest->parent.empty(); ++finest) {
    sums = sumOverChildren(*finest, (finest + 1)->nodeCount(), sums);
  }
  blocks.levels.erase(blocks.levels.begin(), finest);
  blocks.count = sums.col(0);
  const Eigen::VectorXd fraction = blocks.count.cwiseInverse();
  blocks.ahead = fraction.cwiseProduct(sums.col(1));
  blocks.centers = fraction.asDiagonal() * sums.rightCols(3);
  return blocks;
}

/// The combination of the first modes that is nearest to the given ordering; empty if the modes are
/// not found.
Eigen::VectorXd modeAlong(const Blocks& part, int modes) {
  const int count = int(std::min<Eigen::Index>(modes, part.size() - 1));
  const auto found = coarseToFineModes(part.levels, count, kResidual);
  if (!found) return {};
  const auto centered = [&](const Eigen::MatrixXd& values) -> Eigen::MatrixXd {
    return values.rowwise() - part.count.transpose() * values / part.count.sum();
  };
  const Eigen::MatrixXd vectors = centered(found->vectors);
  const Eigen::MatrixXd weighted = vectors.transpose() * part.count.asDiagonal();
  return vectors * (weighted * vectors).ldlt().solve(weighted * centered(part.ahead));
}

/// Scales a mode so that a few voxels lie below 0 and above 1, as the outermost may be a corner.
Eigen::VectorXd siteValues(const Eigen::VectorXd& mode, const Eigen::VectorXd& count) {
  std::vector<std::pair<double, double>> sorted;
  for (Eigen::Index i = 0; i < mode.size(); ++i) sorted.emplace_back(mode[i], count[i]);
  std::sort(sorted.begin(), sorted.end());
  const double outside = kOutside * count.sum();
  const auto valueBeyond = [&](auto at) {
    for (double passed = at->second; passed <= outside; passed += at->second) ++at;
    return at->first;
  };
  const double low = valueBeyond(sorted.begin());
  const double high = valueBeyond(sorted.rbegin());
  return ((mode.array() - low) / std::max(high - low, 1e-12)).max(0.0).min(1.0);
}

void sampleEvenly(const LeastSquaresSpline& spline, PartCurve* curve) {
  std::vector<double> length{0.0};
  for (int i = 1; i <= kSamples; ++i) {
    length.push_back(
        length.back() +
        (spline.at(i / double(kSamples)) - spline.at((i - 1) / double(kSamples))).norm());
  }
  for (int p = 0; p < kPoints; ++p) {
    const double wanted = length.back() * p / (kPoints - 1);
    const auto above = std::lower_bound(length.begin() + 1, length.end() - 1, wanted);
    const double step = *above - *(above - 1);
    const double part = step > 0.0 ? std::min(1.0, (wanted - *(above - 1)) / step) : 0.0;
    const double s = (double(above - length.begin()) - 1.0 + part) / kSamples;
    curve->site_values.push_back(s);
    curve->points.push_back(spline.at(s));
  }
}

}  // namespace

PartCurve fitPartCurve(const VoxelGraph& voxels, const std::vector<uint32_t>& nodes,
                       const std::vector<double>& ahead, int modes, int pieces) {
  PartCurve curve;
  curve.voxel_count = uint32_t(nodes.size());
  std::vector<uint32_t> kept = nodes;
  BlockGraph part = componentOf(voxels.graph, &kept);
  if (kept.size() < kMinNodes) return curve;
  const Blocks blocks = blocksOf(voxels, std::move(part), kept, ahead, modes);
  const Eigen::VectorXd mode = modeAlong(blocks, modes);
  if (mode.size() == 0) return curve;
  const Eigen::VectorXd sites = siteValues(mode, blocks.count);
  sampleEvenly(LeastSquaresSpline(sites, blocks.centers, blocks.count, pieces), &curve);
  curve.seen = true;
  return curve;
}

}  // namespace markerless_mocap
