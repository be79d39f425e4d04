#include "skeleton/graph/tree_graph.h"

#include <gtest/gtest.h>

#include "skeleton/graph/tree_chains.h"
#include "skeleton/graph/tree_metric.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

constexpr double kGap = 0.15, kLoop = 0.12;

CurveSkeleton cross(double pitch) {
  TreeFigure figure(pitch);
  figure.line({0, 0, 0.2}, {0, 0, 1.6}).line({0, -0.5, 1.2}, {0, 0.5, 1.2});
  return figure.skeleton();
}

TEST(TreeGraph, StartsAtTheTopAndGoesDown) {
  const TreeGraph graph = makeTreeGraph(cross(0.02), kGap, kLoop);
  EXPECT_EQ(graph.parents[0], -1);
  for (size_t node = 1; node < graph.size(); ++node) {
    EXPECT_LT(graph.parents[node], int32_t(node));
    EXPECT_LE(graph.positions[node].z(), graph.positions[0].z() + 1e-9);
  }
  EXPECT_TRUE(graph.loop_edges.empty());
}

TEST(TreeGraph, LengthsAreMetresAtAnyPitch) {
  for (const double pitch : {0.01, 0.02, 0.03})
    EXPECT_NEAR(longestPathLength(makeTreeGraph(cross(pitch), kGap, kLoop)), 1.5, 0.06) << pitch;
}

TEST(TreeGraph, SlantedLinesAreNotLongerThanTheyAre) {
  TreeFigure figure(0.015);
  figure.line({0, -0.6, 0.3}, {0.23, 0.6, 1.1});
  const double length = (Eigen::Vector3d(0.23, 1.2, 0.8)).norm();
  EXPECT_NEAR(longestPathLength(makeTreeGraph(figure.skeleton(), kGap, kLoop)), length, 0.03);
}

TEST(TreeGraph, LongLoopIsClosedByOneEdgeAndBendsOfVoxelsByNone) {
  TreeFigure figure(0.02);
  figure.line({0, 0, 0.3}, {0, 0, 1.5})
      .line({0, 0, 1.3}, {0, 0.4, 0.9})
      .line({0, 0.4, 0.9}, {0, 0, 0.5});
  EXPECT_EQ(makeTreeGraph(figure.skeleton(), kGap, kLoop).loop_edges.size(), 1u);
  TreeFigure thick(0.02);
  thick.line({0, 0, 0.3}, {0, 0, 1.5}).line({0, 0.02, 0.8}, {0, 0.02, 0.84});
  EXPECT_TRUE(makeTreeGraph(thick.skeleton(), kGap, kLoop).loop_edges.empty());
}

TEST(TreeGraph, NearComponentsAreJoinedAndFarOnesLeftOut) {
  TreeFigure figure(0.02);
  figure.line({0, 0, 0.3}, {0, 0, 1.0})
      .line({0, 0, 1.1}, {0, 0, 1.4})
      .line({0.8, 0, 0.3}, {0.8, 0, 0.6});
  const TreeGraph graph = makeTreeGraph(figure.skeleton(), kGap, kLoop);
  EXPECT_NEAR(longestPathLength(graph), 1.1, 0.05);
  for (const Eigen::Vector3d& p : graph.positions) EXPECT_LT(p.x(), 0.1);
}

TEST(TreeGraph, ManyComponentsAndNothingAreTaken) {
  TreeFigure figure(0.02);
  for (int i = 0; i < 20; ++i) figure.line({-1.1 + 0.1 * i, 0.9, 0.5}, {-1.1 + 0.1 * i, 0.9, 0.52});
  EXPECT_GT(makeTreeGraph(figure.skeleton(), 0.0, kLoop).size(), 0u);
  EXPECT_EQ(makeTreeGraph(CurveSkeleton(), kGap, kLoop).size(), 0u);
}

TEST(TreeChains, CrossHasFourChains) {
  const TreeGraph graph = makeTreeGraph(cross(0.02), kGap, kLoop);
  const TreeChains tree = makeChains(graph);
  TreeChains pruned = tree;
  pruneChains(0.1, &pruned);
  ASSERT_EQ(pruned.chains.size(), 4u);
  const TreeMetric metric(graph, pruned);
  EXPECT_EQ(metric.ends().size(), 4u);
  EXPECT_EQ(metric.branchings().size(), 1u);
}

TEST(TreeChains, SpursGoAndWhatTheyDividedIsOneAgain) {
  TreeFigure figure(0.02);
  figure.line({0, 0, 0.2}, {0, 0, 1.6}).line({0, 0, 0.8}, {0, 0.08, 0.8});
  const TreeGraph graph = makeTreeGraph(figure.skeleton(), kGap, kLoop);
  TreeChains tree = makeChains(graph);
  EXPECT_GT(tree.chains.size(), 1u);
  pruneChains(0.15, &tree);
  ASSERT_EQ(tree.chains.size(), 1u);
  EXPECT_NEAR(tree.chains[0].length, 1.4, 0.05);
}

}  // namespace
}  // namespace markerless_mocap
