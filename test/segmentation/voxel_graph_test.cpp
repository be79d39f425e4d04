#include "segmentation/voxel_graph.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "segmentation/limbs/bridges.h"

namespace markerless_mocap {
namespace {

VisualHull hullOf(const std::vector<Eigen::Vector3i>& cells) {
  VisualHull hull;
  hull.lattice.size = {12, 12, 12};
  hull.lattice.pitch = 0.1;
  hull.status = HullStatus::kOk;
  for (const Eigen::Vector3i& c : cells) {
    HullVoxel voxel;
    voxel.index = hull.lattice.index(c.x(), c.y(), c.z());
    hull.voxels.push_back(voxel);
  }
  return hull;
}

VisualHull cube(int side) {
  std::vector<Eigen::Vector3i> cells;
  for (int i = 0; i < side * side * side; ++i) {
    cells.emplace_back(i % side, i / side % side, i / (side * side));
  }
  return hullOf(cells);
}

std::map<std::pair<uint32_t, uint32_t>, double> weightsOf(const WeightedGraph& graph) {
  std::map<std::pair<uint32_t, uint32_t>, double> weights;
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      weights[{node, graph.neighbor[e]}] = graph.weight[e];
    }
  }
  return weights;
}

void expectSymmetric(const WeightedGraph& graph) {
  const auto weights = weightsOf(graph);
  for (const auto& [pair, weight] : weights) {
    EXPECT_GT(weight, 0.0);
    EXPECT_EQ(weights.at({pair.second, pair.first}), weight);
  }
}

TEST(VoxelGraph, JoinsFaceNeighborsOfACube) {
  const VoxelGraph voxels = buildVoxelGraph(cube(2));
  ASSERT_EQ(voxels.graph.nodeCount(), 8u);
  const auto weights = weightsOf(voxels.graph);
  EXPECT_EQ(weights.size(), 24u);  // 12 edges, twice
  EXPECT_EQ(weights.count({0, 1}) + weights.count({0, 2}) + weights.count({0, 4}), 3u);
  for (const auto& [pair, weight] : weights) EXPECT_EQ(weight, 1.0);
}

TEST(VoxelGraph, MeasuresDepthUnderTheSurface) {
  const VoxelGraph voxels = buildVoxelGraph(cube(5));
  EXPECT_DOUBLE_EQ(voxels.depth[62], 0.25);  // the centre, 2.5 voxels of 0.1 m
  EXPECT_DOUBLE_EQ(voxels.depth[61], 0.15);
  EXPECT_DOUBLE_EQ(voxels.depth[0], 0.05);
}

TEST(VoxelGraph, GivesBonusByTheVotesOfEquation315) {
  EXPECT_EQ(colorBonus(8, 8), 1.0);
  EXPECT_EQ(colorBonus(4, 8), 0.5);
  EXPECT_EQ(colorBonus(7, 8), 0.5);
  EXPECT_EQ(colorBonus(3, 8), -0.9);
  EXPECT_EQ(colorBonus(0, 0), 0.0);
}

TEST(VoxelGraph, AddsTheBonusToTheEdgeTheVotesAreAbout) {
  VisualHull hull = hullOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
  for (const uint32_t other : {1u, 2u, 3u}) EXPECT_GT(hull.voxels[other].index, 0u);
  hull.voxels[0].color_votes.votes = {8, 5, 1};
  hull.voxels[0].color_votes.possible = {8, 8, 8};
  const auto weights = weightsOf(buildVoxelGraph(hull, {true, 0.0}).graph);
  EXPECT_DOUBLE_EQ(weights.at({0, 1}), 2.0);
  EXPECT_DOUBLE_EQ(weights.at({0, 2}), 1.5);
  EXPECT_DOUBLE_EQ(weights.at({0, 3}), 0.1);
  EXPECT_DOUBLE_EQ(weights.at({3, 0}), 0.1);
  EXPECT_EQ(weightsOf(buildVoxelGraph(hull).graph).at({0, 3}), 1.0);
}

TEST(VoxelGraph, TakesTheConstantsOfEquation315) {
  ColorBonus bonus;
  bonus.all = 0.8;
  bonus.most = 0.3;
  bonus.few = -0.5;
  bonus.most_from = 0.75;
  bonus.few_below = 0.25;
  EXPECT_EQ(colorBonus(8, 8, bonus), 0.8);
  EXPECT_EQ(colorBonus(6, 8, bonus), 0.3);
  EXPECT_EQ(colorBonus(5, 8, bonus), 0.0);  // neither most nor few
  EXPECT_EQ(colorBonus(2, 8, bonus), 0.0);
  EXPECT_EQ(colorBonus(1, 8, bonus), -0.5);
}

// Hsiao 2008, 3.1.4.2 A-2.
TEST(VoxelGraph, RaisesWeightsAtTheNodesOfLargestDegree) {
  const auto weights = weightsOf(buildVoxelGraph(cube(5), {false, 2.0, 1.0}).graph);
  EXPECT_EQ(weights.at({62, 61}), 3.0);  // inside
  EXPECT_EQ(weights.at({61, 60}), 3.0);  // from inside to a face
  EXPECT_EQ(weights.at({0, 1}), 1.0);    // along an edge of the cube
  EXPECT_EQ(weights.at({6, 7}), 1.0);    // within a face
}

TEST(VoxelGraph, RaisesWeightsAtTheCoreOnly) {
  const VoxelGraph voxels = buildVoxelGraph(cube(5), {false, 7.0});
  expectSymmetric(voxels.graph);
  const auto weights = weightsOf(voxels.graph);
  EXPECT_EQ(weights.at({62, 61}), 8.0);  // the centre and its neighbour
  EXPECT_EQ(weights.at({61, 60}), 1.0);
  EXPECT_EQ(weights.at({0, 1}), 1.0);
  EXPECT_EQ(std::count_if(weights.begin(), weights.end(), [](auto& w) { return w.second > 1.0; }),
            12);
}

TEST(VoxelGraph, BridgesPiecesThatTouchByACorner) {
  const VoxelGraph voxels = buildVoxelGraph(hullOf({{1, 1, 1}, {2, 1, 1}, {3, 2, 2}, {4, 2, 2}}));
  ASSERT_EQ(voxels.graph.nodeCount(), 4u);
  EXPECT_TRUE(voxels.left_out.empty());
  EXPECT_EQ(weightsOf(voxels.graph).count({1, 2}), 1u);
  expectSymmetric(voxels.graph);
}

TEST(BridgeEdges, JoinEachPairOfTouchingPiecesOnceByAscendingNodes) {
  const auto pairsOf = [](const std::vector<Eigen::Vector3i>& cells,
                          const std::vector<uint32_t>& component) {
    std::vector<std::pair<uint32_t, uint32_t>> pairs;
    for (const Edge& edge : bridgeEdges(NodeGrid(cells), component)) {
      pairs.emplace_back(edge.from, edge.to);
    }
    return pairs;
  };
  using Pairs = std::vector<std::pair<uint32_t, uint32_t>>;
  // A bar, a voxel at its end's edge, and one at that voxel's corner.
  EXPECT_EQ(pairsOf({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 1, 0}, {4, 2, 1}}, {0, 0, 0, 1, 2}),
            (Pairs{{2, 3}, {3, 4}}));
  EXPECT_EQ(pairsOf({{4, 2, 0}, {3, 1, 1}, {0, 0, 2}, {1, 0, 2}, {2, 0, 2}}, {0, 1, 2, 2, 2}),
            (Pairs{{0, 1}, {1, 4}}));
}

TEST(VoxelGraph, BridgesNothingWithinAPiece) {
  // A hook whose ends touch by an edge.
  const VoxelGraph voxels = buildVoxelGraph(
      hullOf(
          {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}, {1, 0, 3}, {0, 0, 1}}),
      {});
  EXPECT_EQ(weightsOf(voxels.graph).size(), 14u);  // 7 edges, twice
}

TEST(VoxelGraph, TellsWhatIsNotConnected) {
  const VoxelGraph voxels =
      buildVoxelGraph(hullOf({{0, 0, 0}, {9, 9, 9}, {1, 0, 0}, {9, 9, 8}, {2, 0, 0}}));
  EXPECT_EQ(voxels.hull_voxel, (std::vector<uint32_t>{0, 2, 4}));
  EXPECT_EQ(voxels.left_out, (std::vector<uint32_t>{3, 1}));
  EXPECT_EQ(voxels.centers.size(), 3u);
  EXPECT_TRUE(voxels.centers[1].isApprox(Eigen::Vector3d(0.15, 0.05, 0.05)));
}

TEST(VoxelGraph, DoesNotDependOnTheOrderOfVoxels) {
  VisualHull hull = cube(3);
  const VoxelGraph sorted = buildVoxelGraph(hull, {false, 1.0});
  std::reverse(hull.voxels.begin(), hull.voxels.end());
  const VoxelGraph reversed = buildVoxelGraph(hull, {false, 1.0});
  EXPECT_EQ(weightsOf(sorted.graph), weightsOf(reversed.graph));
  EXPECT_EQ(reversed.hull_voxel.front(), 26u);
}

}  // namespace
}  // namespace markerless_mocap
