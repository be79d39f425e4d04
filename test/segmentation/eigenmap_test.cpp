#include "segmentation/eigenmap.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

WeightedGraph path(uint32_t nodes) {
  std::vector<Edge> edges;
  for (uint32_t i = 0; i + 1 < nodes; ++i) edges.push_back({i, i + 1, 1.0});
  return graphOfEdges(nodes, edges);
}

WeightedGraph weightedBox(uint32_t nx, uint32_t ny, uint32_t nz) {
  std::vector<Edge> edges;
  for (uint32_t n = 0; n < nx * ny * nz; ++n) {
    const double weight = 1.0 + 0.1 * (n % 7);
    if (n % nx + 1 < nx) edges.push_back({n, n + 1, weight});
    if (n / nx % ny + 1 < ny) edges.push_back({n, n + nx, weight});
    if (n / (nx * ny) + 1 < nz) edges.push_back({n, n + nx * ny, weight});
  }
  return graphOfEdges(nx * ny * nz, edges);
}

Eigen::MatrixXd adjacency(const WeightedGraph& graph) {
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(graph.nodeCount(), graph.nodeCount());
  for (uint32_t node = 0; node < graph.nodeCount(); ++node) {
    for (uint32_t e = graph.row_start[node]; e < graph.row_start[node + 1]; ++e) {
      matrix(node, graph.neighbor[e]) = graph.weight[e];
    }
  }
  return matrix;
}

// L u = lambda D u on a path of n nodes: u_i = cos(pi k i / (n - 1)), lambda = 1 - cos(pi k / (n -
// 1)).
class PathSpectrum : public testing::TestWithParam<uint32_t> {};

TEST_P(PathSpectrum, IsThatOfTheChain) {
  const uint32_t nodes = GetParam();
  const Eigenmap map = laplacianEigenmap(path(nodes), 4);
  ASSERT_EQ(map.values.size(), 4);
  for (int k = 1; k <= 4; ++k) {
    EXPECT_NEAR(map.values[k - 1], 1.0 - std::cos(M_PI * k / (nodes - 1)), 1e-8);
  }
  const double sign = map.vectors(0, 0) > 0.0 ? 1.0 : -1.0;
  const double scale = std::abs(map.vectors(0, 0));
  for (uint32_t i = 0; i < nodes; ++i) {
    EXPECT_NEAR(map.vectors(i, 0) * sign, scale * std::cos(M_PI * i / (nodes - 1)), 1e-3);
  }
}

// The dense solver takes small graphs, the sparse one large graphs.
INSTANTIATE_TEST_SUITE_P(SmallAndLarge, PathSpectrum, testing::Values(12u, 150u));

TEST(Eigenmap, FindsTheDoubleValuesOfACycle) {
  const uint32_t nodes = 90;
  std::vector<Edge> edges;
  for (uint32_t i = 0; i < nodes; ++i) edges.push_back({i, (i + 1) % nodes, 3.0});
  const Eigenmap map = laplacianEigenmap(graphOfEdges(nodes, edges), 4);
  for (int k = 0; k < 4; ++k) {
    EXPECT_NEAR(map.values[k], 1.0 - std::cos(2.0 * M_PI * (k / 2 + 1) / nodes), 1e-8);
  }
}

TEST(Eigenmap, AgreesWithTheDenseGeneralizedSolver) {
  const WeightedGraph graph = weightedBox(8, 6, 5);
  const Eigen::MatrixXd weights = adjacency(graph);
  const Eigen::MatrixXd degree = weights.rowwise().sum().asDiagonal();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> dense(degree - weights, degree);
  const Eigenmap map = laplacianEigenmap(graph, 6);
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(map.values[k], dense.eigenvalues()[k + 1], 1e-7);
    const Eigen::VectorXd residual =
        (degree - weights) * map.vectors.col(k) - map.values[k] * degree * map.vectors.col(k);
    EXPECT_LT(residual.norm(), 1e-3 * (degree * map.vectors.col(k)).norm());
  }
}

TEST(Eigenmap, IsOrthonormalUnderTheDegreesAndFreeOfTheConstant) {
  const WeightedGraph graph = weightedBox(8, 6, 5);
  const Eigen::VectorXd degree = adjacency(graph).rowwise().sum();
  const Eigen::MatrixXd u = laplacianEigenmap(graph, 6).vectors;
  const Eigen::MatrixXd product = u.transpose() * degree.asDiagonal() * u / degree.sum();
  EXPECT_TRUE(product.isApprox(Eigen::MatrixXd::Identity(6, 6), 1e-6));
  EXPECT_LT((u.transpose() * degree).norm() / degree.sum(), 1e-6);
}

TEST(Eigenmap, IsTheSameEachTimeWithTheLargestEntryPositive) {
  const WeightedGraph graph = weightedBox(7, 5, 4);
  const Eigenmap once = laplacianEigenmap(graph, 5);
  EXPECT_EQ(once.vectors, laplacianEigenmap(graph, 5).vectors);
  for (int k = 0; k < 5; ++k) {
    EXPECT_GE(once.vectors.col(k).maxCoeff(), -once.vectors.col(k).minCoeff());
  }
}

TEST(Eigenmap, ReturnsAsManyModesAsExist) {
  EXPECT_EQ(laplacianEigenmap(path(3), 10).values.size(), 2);
  EXPECT_EQ(laplacianEigenmap(path(1), 10).values.size(), 0);
  EXPECT_EQ(laplacianEigenmap(path(1), 10).vectors.rows(), 1);
}

TEST(Eigenmap, WantsAtLeastOneMode) {
  EXPECT_THROW(laplacianEigenmap(path(5), 0), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
