#include "segmentation/graph_modes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "segmentation/box_graph.h"
#include "segmentation/eigenmap/graph_hierarchy.h"
#include "segmentation/voxel_figure.h"
#include "segmentation/voxel_graph.h"

namespace markerless_mocap {
namespace {

struct Weights {
  const char* name;
  bool votes;
  double shrink;
};

class CoarseToFine : public testing::TestWithParam<Weights> {};

TEST_P(CoarseToFine, SpansTheSpaceOfTheReference) {
  VisualHull hull = standingFigure(1.0).hull();
  for (HullVoxel& voxel : hull.voxels) {
    voxel.color_votes.votes = {uint8_t(voxel.index % 9), uint8_t(voxel.index % 5), 8};
    voxel.color_votes.possible = {8, 8, 8};
  }
  const WeightedGraph graph = buildVoxelGraph(hull, {GetParam().votes, GetParam().shrink}).graph;
  const Eigen::VectorXd degree = degreesOf(graph);
  for (const int modes : {3, 6, 10}) {
    const auto found = coarseToFineModes(graph, modes, 3e-3);
    ASSERT_TRUE(found.has_value());
    const GraphModes reference = shiftInvertModes(graph, modes);
    EXPECT_LT(sineBetween(found->vectors, reference.vectors, degree), 1e-3);
    EXPECT_LE(found->residuals.maxCoeff(), 3e-3);
    for (int k = 0; k < modes; ++k) {
      EXPECT_NEAR(found->values[k], reference.values[k], 1e-5 * reference.values[k]);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Figure, CoarseToFine,
                         testing::Values(Weights{"plain", false, 0.0}, Weights{"votes", true, 0.0},
                                         Weights{"shrunk", false, 2.0},
                                         Weights{"shrunk_much", true, 100.0}),
                         [](const auto& info) { return std::string(info.param.name); });

TEST(CoarseToFineModes, TellTheirResiduals) {
  const WeightedGraph graph = buildVoxelGraph(standingFigure(1.0).hull()).graph;
  const Eigen::VectorXd degree = degreesOf(graph);
  const auto found = coarseToFineModes(graph, 6, 1e-2);
  ASSERT_TRUE(found.has_value());
  for (int mode = 0; mode < 6; ++mode) {
    const Eigen::VectorXd u = found->vectors.col(mode);
    double squares = 0.0;
    for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
      double rest = -found->values[mode] * degree[node] * u[node];
      for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
        rest += graph.weight[e] * (u[node] - u[graph.neighbor[e]]);
      }
      squares += rest * rest / degree[node];
    }
    EXPECT_NEAR(std::sqrt(squares) / found->values[mode], found->residuals[mode],
                0.1 * found->residuals[mode]);
  }
}

TEST(CoarseToFineModes, AreOrthonormalAndFreeOfTheConstant) {
  const WeightedGraph graph = buildVoxelGraph(standingFigure(1.2).hull()).graph;
  const Eigen::VectorXd degree = degreesOf(graph);
  const auto found = coarseToFineModes(graph, 10, 1e-2);
  ASSERT_TRUE(found.has_value());
  const Eigen::MatrixXd product = found->vectors.transpose() * degree.asDiagonal() * found->vectors;
  EXPECT_TRUE(product.isApprox(Eigen::MatrixXd::Identity(10, 10), 1e-6));
  EXPECT_LT((found->vectors.transpose() * degree).norm() / std::sqrt(degree.sum()), 1e-5);
}

// A path's values are 1 - cos(pi k / (n - 1)), whatever lies between the cells of a long one.
TEST(CoarseToFineModes, FindTheSpectrumOfAPath) {
  const auto found = coarseToFineModes(box(400, 1, 1), 4, 2e-3);
  ASSERT_TRUE(found.has_value());
  for (int k = 1; k <= 4; ++k) {
    const double expected = 1.0 - std::cos(M_PI * k / 399);
    EXPECT_NEAR(found->values[k - 1], expected, 1e-4 * expected);
  }
}

// Under D the modes of a box do not separate, but the space of functions that are even or odd about
// each middle plane does: the first mode of a long box is odd along it, the second even.
TEST(CoarseToFineModes, HaveTheSymmetriesOfABox) {
  const int n = 40;
  const WeightedGraph graph = box(n, 7, 5);
  const auto found = coarseToFineModes(graph, 3, 2e-3);
  ASSERT_TRUE(found.has_value());
  for (int mode = 0; mode < 3; ++mode) {
    const double sign = mode % 2 == 0 ? -1.0 : 1.0;
    const double height = found->vectors.col(mode).cwiseAbs().maxCoeff();
    for (int node = 0; node < int(graph.nodeCount()); ++node) {
      const int mirrored = node - node % n + (n - 1 - node % n);
      EXPECT_NEAR(found->vectors(node, mode), sign * found->vectors(mirrored, mode), 0.01 * height);
    }
  }
}

TEST(CoarseToFineModes, DoNotFitWhereThereIsNothingToCoarsen) {
  WeightedGraph graph = box(20, 20, 3);
  EXPECT_TRUE(coarseToFineModes(graph, 6, 1e-2).has_value());
  EXPECT_FALSE(coarseToFineModes(graph, 24, 1e-2).has_value());
  EXPECT_FALSE(coarseToFineModes(box(3, 3, 3), 6, 1e-2).has_value());
  graph.cell.clear();
  EXPECT_FALSE(coarseToFineModes(graph, 6, 1e-2).has_value());
}

TEST(CoarseToFineModes, AreNotGivenWithoutConvergence) {
  EXPECT_FALSE(coarseToFineModes(box(20, 20, 20), 6, 1e-12).has_value());
}

TEST(GraphHierarchy, KeepsLimbsApartThatShareABlock) {
  // Two paths side by side, joined at one end only.
  std::vector<Edge> edges;
  std::vector<LatticeCell> cells;
  for (uint32_t n = 0; n < 100; ++n) {
    cells.emplace_back(int(n), 0, 0);
    if (n > 0) edges.push_back({n - 1, n, 1.0});
  }
  for (uint32_t n = 0; n < 100; ++n) {
    cells.emplace_back(int(n), 1, 0);
    if (n > 0) edges.push_back({99 + n, 100 + n, 1.0});
  }
  edges.push_back({0, 100, 1.0});
  WeightedGraph graph = graphOfEdges(200, edges);
  graph.cell = cells;
  const std::vector<GraphLevel> levels =
      buildHierarchy(gatherNodes(graph, allNodesOf(graph)), 8, 120);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[1].nodeCount(), 99u);  // 50 and 50, of which the joined end is one
  EXPECT_NE(levels[0].parent[60], levels[0].parent[160]);
  EXPECT_EQ(levels[0].parent[0], levels[0].parent[100]);
}

TEST(GraphHierarchy, KeepsTheSumsOfMassesAndCrossingWeights) {
  const WeightedGraph graph = buildVoxelGraph(standingFigure(0.8).hull(), {false, 1.5}).graph;
  const std::vector<GraphLevel> levels =
      buildHierarchy(gatherNodes(graph, allNodesOf(graph)), 24, 64);
  ASSERT_GE(levels.size(), 3u);
  const GraphLevel& fine = levels[0];
  const GraphLevel& coarse = levels[1];
  double crossing = 0.0;
  for (uint32_t node = 0; node < fine.nodeCount(); ++node) {
    for (uint32_t e = fine.row_start[node]; e < fine.row_start[node + 1]; ++e) {
      if (fine.parent[node] != fine.parent[fine.neighbor[e]]) crossing += double(fine.weight[e]);
    }
  }
  double weights = 0.0;
  for (const float w : coarse.weight) weights += double(w);
  EXPECT_NEAR(weights, crossing, 1e-5 * crossing);
  double mass = 0.0;
  for (const float m : coarse.mass) mass += double(m);
  EXPECT_NEAR(mass, degreesOf(graph).sum(), 1e-5 * mass);
}

}  // namespace
}  // namespace markerless_mocap
