#include "segmentation/eigenmap/node_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <tuple>

namespace markerless_mocap {
namespace {

/// Cells of a random walk that often crosses itself: paths along it turn in all directions.
std::vector<Eigen::Vector3i> windingCells(int steps) {
  std::mt19937 random(7);
  std::set<std::tuple<int, int, int>> known;  // z, y, x
  Eigen::Vector3i at(0, 0, 0);
  for (int step = 0; step < steps; ++step) {
    known.emplace(at.z(), at.y(), at.x());
    at[int(random() % 3)] += random() % 2 == 0 ? 1 : -1;
  }
  std::vector<Eigen::Vector3i> cells;
  for (const auto& [z, y, x] : known) cells.emplace_back(x, y, z);
  return cells;
}

/// Ways relaxed over all pairs of neighbours until none is shorter (Bellman 1958).
std::vector<double> bellmanWays(const std::vector<Eigen::Vector3i>& cells, uint32_t source) {
  std::vector<int> cost(cells.size(), std::numeric_limits<int>::max() / 2);
  cost[source] = 0;
  for (bool falls = true; falls;) {
    falls = false;
    for (size_t a = 0; a < cells.size(); ++a) {
      for (size_t b = 0; b < cells.size(); ++b) {
        const Eigen::Vector3i step = (cells[a] - cells[b]).cwiseAbs();
        if (a == b || step.maxCoeff() > 1 || cost[b] + 2 + step.sum() >= cost[a]) continue;
        cost[a] = cost[b] + 2 + step.sum();
        falls = true;
      }
    }
  }
  std::vector<double> distances;
  for (const int c : cost) distances.push_back(c / 3.0);
  return distances;
}

TEST(NodeGrid, MeasuresWaysAroundCorners) {
  // An L: four to the right, then three up.
  const NodeGrid grid(
      {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {3, 0, 1}, {3, 0, 2}, {9, 9, 9}});
  const std::vector<double> geodesic = grid.geodesics({0});
  EXPECT_DOUBLE_EQ(geodesic[3], 3.0);
  EXPECT_DOUBLE_EQ(geodesic[4], 2.0 + 4.0 / 3.0);  // cuts the corner by one diagonal step
  EXPECT_DOUBLE_EQ(geodesic[5], 3.0 + 4.0 / 3.0);
  EXPECT_TRUE(std::isinf(geodesic[6]));
}

TEST(NodeGrid, MeasuresWaysFromEachSourceByItself) {
  const NodeGrid grid({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {9, 9, 9}, {9, 9, 10}});
  const auto distances = grid.geodesicsOfEach({0, 2, 4});
  ASSERT_EQ(distances.size(), 3u);
  EXPECT_EQ(distances[0], grid.geodesics({0}));
  EXPECT_EQ(distances[1], grid.geodesics({2}));
  EXPECT_EQ(distances[2], grid.geodesics({4}));
}

TEST(NodeGrid, FindsTheShortestOfWaysThatTurn) {
  const std::vector<Eigen::Vector3i> cells = windingCells(600);
  const NodeGrid grid(cells);
  std::vector<uint32_t> sources;
  for (uint32_t i = 0; i < 11; ++i) sources.push_back(uint32_t((i * 97 + 13) % cells.size()));
  const auto distances = grid.geodesicsOfEach(sources);
  ASSERT_EQ(distances.size(), sources.size());
  for (size_t i = 0; i < sources.size(); ++i) {
    const std::vector<double> expected = bellmanWays(cells, sources[i]);
    for (size_t node = 0; node < cells.size(); ++node)
      ASSERT_DOUBLE_EQ(distances[i][node], expected[node])
          << "from " << sources[i] << " to " << node;
  }
}

TEST(NodeGrid, TakesTheNearestOfSeveralSources) {
  const std::vector<Eigen::Vector3i> cells = windingCells(400);
  const NodeGrid grid(cells);
  const uint32_t last = uint32_t(cells.size()) - 1;
  const std::vector<double> nearest = grid.geodesics({last, 0});
  const auto distances = grid.geodesicsOfEach({0, last});
  for (size_t node = 0; node < cells.size(); ++node)
    ASSERT_DOUBLE_EQ(nearest[node], std::min(distances[0][node], distances[1][node]));
}

TEST(NodeGridRegion, TakesOutWhatIsConnectedOverCorners) {
  // A chain over an edge and a corner, and a piece two steps away.
  const NodeGrid grid({{0, 0, 0}, {1, 0, 0}, {2, 1, 0}, {5, 1, 0}, {3, 2, 1}});
  NodeGrid::Region region(grid);
  EXPECT_FALSE(region.has(0));
  region.put({0, 1, 2, 3, 4});
  EXPECT_EQ(region.takeConnected(4, 9), (std::vector<uint32_t>{4, 2, 1, 0}));
  EXPECT_FALSE(region.has(0));
  EXPECT_TRUE(region.has(3));
  region.put({0, 1, 2, 4});
  region.remove({2});
  EXPECT_EQ(region.takeConnected(0, 9), (std::vector<uint32_t>{0, 1}));
  region.put({0, 1, 2});
  region.takeConnected(0, 1);  // ends at 1
  EXPECT_TRUE(region.has(2));
}

TEST(NodeGrid, RefusesCellsThatDoNotAscend) {
  EXPECT_THROW(NodeGrid({{0, 0, 1}, {3, 0, 0}}), std::invalid_argument);
  EXPECT_THROW(NodeGrid({{2, 1, 0}, {2, 1, 0}}), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
