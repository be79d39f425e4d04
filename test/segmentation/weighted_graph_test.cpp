#include "segmentation/weighted_graph.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

double weightBetween(const WeightedGraph& graph, uint32_t a, uint32_t b) {
  for (uint32_t e = graph.row_start[a]; e < graph.row_start[a + 1]; ++e) {
    if (graph.neighbor[e] == b) return graph.weight[e];
  }
  return 0.0;
}

TEST(WeightedGraph, HoldsEachEdgeFromBothEnds) {
  const WeightedGraph graph = graphOfEdges(3, {{0, 1, 2.0}, {2, 1, 0.5}});
  EXPECT_EQ(graph.nodeCount(), 3u);
  EXPECT_EQ(graph.neighbor.size(), 4u);
  EXPECT_EQ(weightBetween(graph, 0, 1), 2.0);
  EXPECT_EQ(weightBetween(graph, 1, 0), 2.0);
  EXPECT_EQ(weightBetween(graph, 1, 2), 0.5);
  EXPECT_EQ(weightBetween(graph, 2, 1), 0.5);
  EXPECT_EQ(weightBetween(graph, 0, 2), 0.0);
}

TEST(WeightedGraph, NumbersComponentsByTheirLowestNode) {
  const WeightedGraph graph = graphOfEdges(6, {{0, 3, 1.0}, {1, 4, 1.0}, {4, 5, 1.0}});
  EXPECT_EQ(connectedComponents(graph), (std::vector<uint32_t>{0, 1, 2, 0, 1, 1}));
}

TEST(MostFrequent, IsTheLowestOfEquals) {
  EXPECT_EQ(mostFrequent({5, 2, 0, 2, 5}), 2u);
  EXPECT_EQ(mostFrequent({0, 3, 3}), 3u);
}

}  // namespace
}  // namespace markerless_mocap
