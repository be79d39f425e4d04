#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "segmentation/limbs/merge_tree.h"
#include "segmentation/limbs/part_naming.h"
#include "segmentation/spline_propagation.h"
#include "segmentation/voxel_graph.h"
#include "segmentation/weighted_graph.h"
#include "voxel_figure.h"

namespace markerless_mocap {
namespace {

using Nodes = std::vector<uint32_t>;

Adjacency path(uint32_t nodes) {
  std::vector<Edge> edges;
  for (uint32_t i = 0; i + 1 < nodes; ++i) edges.push_back({i, i + 1, 1.0});
  const WeightedGraph graph = graphOfEdges(nodes, edges);
  return {graph.row_start, graph.neighbor};
}

const std::vector<double> kHills = {9.0, 2.0, 8.0, 5.0, 7.0};

TEST(MergeTree, OrdersMaximaByPersistence) {
  // 9 stays for good, 8 ends at 2, 7 ends at 5.
  EXPECT_EQ(persistentMaxima(path(5), kHills, 3), (Nodes{0, 2, 4}));
  EXPECT_EQ(persistentMaxima(path(5), kHills, 2), (Nodes{0, 2}));
  EXPECT_EQ(persistentMaxima(path(5), std::vector<double>(5, 1.0), 3), (Nodes{0}));
}

TEST(MergeTree, MeasuresDistanceFromTheCoreInCommuteTime) {
  Eigenmap map{Eigen::Vector2d(0.1, 0.4), Eigen::MatrixXd(3, 2)};
  map.vectors << 1.0, 0.0, 3.0, 0.0, 2.0, 6.0;
  // The core is (2, 0); mode 2 counts half.
  EXPECT_EQ(distanceFromCore(map, {0, 1}), (std::vector<double>{1.0, 1.0, 3.0}));
}

TEST(SplineWalk, TakesTheArmsOfAStar) {
  // Four straight chains of 100 nodes from one centre, laid out as an embedding would.
  Eigenmap map{Eigen::Vector2d(0.1, 0.1), Eigen::MatrixXd::Zero(401, 2)};
  const Eigen::RowVector2d directions[] = {{1, 0}, {0, 0.9}, {-0.8, 0}, {0, -0.7}};
  for (int arm = 0; arm < 4; ++arm) {
    for (int i = 1; i <= 100; ++i) map.vectors.row(arm * 100 + i) = directions[arm] * i / 100.0;
  }
  SplineWalkOptions walk;
  walk.stop_radius = 0.15;
  const std::vector<Branch> branches =
      splinePropagationBranches(map, SplineTermination::kOrigin, 4, walk);
  ASSERT_EQ(branches.size(), 4u);
  for (uint32_t arm = 0; arm < 4; ++arm) {
    EXPECT_EQ(branches[arm].extremity, arm * 100 + 100);
    // All stop at the same distance from the centre.
    EXPECT_NEAR(double(branches[arm].nodes.size()), 100.0 - 15.0 / directions[arm].norm(), 3.0);
    for (const uint32_t node : branches[arm].nodes) EXPECT_EQ((node - 1) / 100, arm);
  }
}

/// A straight chain of 100 nodes that ends at the middle of one edge of a square of 30 x 30.
Eigenmap paddle() {
  Eigenmap map{Eigen::Vector2d(0.1, 0.1), Eigen::MatrixXd(1000, 2)};
  for (int i = 0; i < 100; ++i) map.vectors.row(i) << 2.0 - 0.01 * i, 0.0;
  for (int i = 0; i < 900; ++i) {
    map.vectors.row(100 + i) << 1.0 - 0.02 * (i / 30), 0.02 * (i % 30) - 0.29;
  }
  return map;
}

TEST(SplineWalk, EndsWhereNodesSpreadAsideOfTheSpline) {
  const Branch handle =
      splinePropagationBranches(paddle(), SplineTermination::kOutliers, 1).front();
  EXPECT_EQ(handle.extremity, 0u);
  const auto of_blade = std::count_if(handle.nodes.begin(), handle.nodes.end(),
                                      [](uint32_t node) { return node >= 100; });
  EXPECT_GE(handle.nodes.size() - size_t(of_blade), 95u);
  EXPECT_LT(of_blade, 150);  // the origin is far behind: the other stop takes the blade's middle
  const Branch all = splinePropagationBranches(paddle(), SplineTermination::kOrigin, 1).front();
  EXPECT_GT(all.nodes.size(), handle.nodes.size() + 100);
}

struct Variant {
  const char* name;
  SplineTermination stop;
  double shrink_weight;
};

class SeedsVariants : public testing::TestWithParam<Variant> {};

// Sundaresan's walk overruns into the torso before its outliers tell.
TEST_P(SeedsVariants, FindTheFiveLimbsOfAFigure) {
  const VoxelFigure figure = standingFigure(1.0);
  const VoxelGraph voxels = buildVoxelGraph(figure.hull(), {false, GetParam().shrink_weight});
  const std::vector<PartLabel> parts = figure.parts();
  const std::vector<Branch> branches =
      splinePropagationBranches(laplacianEigenmap(voxels.graph, 6), GetParam().stop, 5);
  std::set<PartLabel> found;
  for (const Branch& branch : branches) {
    const PartLabel part = parts[voxels.hull_voxel[branch.extremity]];
    found.insert(part);
    const auto of_part = double(std::count(parts.begin(), parts.end(), part));
    const auto right =
        double(std::count_if(branch.nodes.begin(), branch.nodes.end(), [&](uint32_t node) {
          return parts[voxels.hull_voxel[node]] == part;
        }));
    EXPECT_GT(right / of_part, 0.7) << toString(part);
    EXPECT_GT(right / double(branch.nodes.size()), 0.6) << toString(part);
  }
  EXPECT_EQ(found.size(), 5u);
  EXPECT_EQ(found.count(PartLabel::kTorso), 0u);
}

INSTANTIATE_TEST_SUITE_P(SplineWalk, SeedsVariants,
                         testing::Values(Variant{"sundaresan", SplineTermination::kOutliers, 0.0},
                                         Variant{"modified", SplineTermination::kOrigin, 100.0}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(SplineWalk, FindsNothingWithoutModes) {
  EXPECT_TRUE(splinePropagationBranches({Eigen::VectorXd(0), Eigen::MatrixXd(1, 0)},
                                        SplineTermination::kOrigin, 5)
                  .empty());
}

/// Measures of a body: head, two arms, two legs in this order.
ExtremityMeasures bodyMeasures() {
  ExtremityMeasures measures;
  measures.fullness = {-2.78, -4.6, -4.6, -3.75, -3.75};
  measures.to_core = {-0.05, 0.4, 0.4, 0.72, 0.72};
  measures.height = {0.95, 0.55, 0.55, 0.03, 0.03};
  measures.distance.resize(5, 5);
  measures.distance << 0, .86, .86, 1.40, 1.40,  //
      .86, 0, 1.10, 1.40, 1.40,                  //
      .86, 1.10, 0, 1.40, 1.40,                  //
      1.40, 1.40, 1.40, 0, 1.20,                 //
      1.40, 1.40, 1.40, 1.20, 0;
  return measures;
}

ExtremityMeasures reordered(const ExtremityMeasures& from, const std::vector<int>& order) {
  ExtremityMeasures to;
  to.distance.resize(order.size(), order.size());
  for (size_t i = 0; i < order.size(); ++i) {
    to.fullness.push_back(from.fullness[order[i]]);
    to.to_core.push_back(from.to_core[order[i]]);
    to.height.push_back(from.height[order[i]]);
    for (size_t j = 0; j < order.size(); ++j) to.distance(i, j) = from.distance(order[i], order[j]);
  }
  return to;
}

TEST(PartNaming, NamesAnAverageBodyAtNoCost) {
  const PartNaming names = assignParts(bodyMeasures());
  EXPECT_EQ(names.extremity, (std::array<int, kPartCount>{-1, 0, 1, 2, 3, 4}));
  EXPECT_NEAR(names.cost, 0.0, 1e-9);
}

TEST(PartNaming, DoesNotDependOnTheOrderOfTips) {
  const PartNaming names = assignParts(reordered(bodyMeasures(), {3, 1, 0, 4, 2}));
  EXPECT_EQ(names.extremity, (std::array<int, kPartCount>{-1, 2, 1, 4, 0, 3}));
}

TEST(PartNaming, LeavesOutWhatIsNotThere) {
  const PartNaming names = assignParts(reordered(bodyMeasures(), {0, 1, 3, 4}));
  EXPECT_EQ(names.extremity, (std::array<int, kPartCount>{-1, 0, 1, -1, 2, 3}));
}

TEST(PartNaming, DoesNotCallASecondFootAnArm) {
  ExtremityMeasures measures = reordered(bodyMeasures(), {0, 1, 3, 4, 4});
  measures.distance(3, 4) = measures.distance(4, 3) = -2.0;  // heel and toes
  const PartNaming names = assignParts(measures);
  EXPECT_EQ(names.extremity[size_t(PartLabel::kArm2)], -1);
  EXPECT_EQ(names.extremity[size_t(PartLabel::kArm1)], 1);
}

TEST(PartNaming, DoesNotNameAnArmTwice) {
  ExtremityMeasures measures = bodyMeasures();  // hand and elbow of one arm
  measures.to_core[2] = -0.1;
  measures.distance(1, 2) = measures.distance(2, 1) = 0.38;  // less than from the hand to the core
  const PartNaming names = assignParts(measures);
  EXPECT_EQ(names.extremity[size_t(PartLabel::kArm1)], 1);
  EXPECT_EQ(names.extremity[size_t(PartLabel::kArm2)], -1);
  measures.distance(1, 2) = measures.distance(2, 1) = 0.42;
  EXPECT_EQ(assignParts(measures).extremity[size_t(PartLabel::kArm2)], 2);
}

TEST(PartNaming, AllowsForAStoutBody) {
  ExtremityMeasures measures = bodyMeasures();
  for (double& length : measures.to_core) length -= 0.15;
  measures.distance.array() -= 0.15;
  const PartNaming names = assignParts(measures);
  EXPECT_EQ(names.extremity, (std::array<int, kPartCount>{-1, 0, 1, 2, 3, 4}));
  EXPECT_NEAR(names.cost, 0.0, 1e-9);
}

TEST(PartNaming, NamesNothingOfNothing) {
  const PartNaming names = assignParts(reordered(bodyMeasures(), {}));
  EXPECT_EQ(names.extremity, (std::array<int, kPartCount>{-1, -1, -1, -1, -1, -1}));
  EXPECT_TRUE(std::isinf(names.cost));
}

TEST(PartNaming, KnowsWhatSizeALimbCanHave) {
  EXPECT_TRUE(isPlausible(PartLabel::kArm1, 0.05, 0.05));
  EXPECT_FALSE(isPlausible(PartLabel::kArm1, 0.0003, 0.05));  // a knuckle
  EXPECT_FALSE(isPlausible(PartLabel::kLeg2, 0.50, 0.09));    // both legs and a hip
}

}  // namespace
}  // namespace markerless_mocap
