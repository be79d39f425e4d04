#include "studies/reproduce/hsiao/plane_figure.h"

#include <gtest/gtest.h>

#include <set>

#include "segmentation/eigenmap.h"
#include "segmentation/spline_propagation.h"
#include "studies/reproduce/hsiao/embedding_drawing.h"

namespace markerless_mocap {
namespace {

double weightBetween(const WeightedGraph& graph, uint32_t a, uint32_t b) {
  for (uint32_t e = graph.row_start[a]; e < graph.row_start[a + 1]; ++e)
    if (graph.neighbor[e] == b) return graph.weight[e];
  return 0.0;
}

/// 7 x 7 pixels, of one colour but for the last column.
cv::Mat square() {
  cv::Mat image(7, 7, CV_8UC3, cv::Scalar(100, 100, 100));
  image.col(6).setTo(cv::Scalar(200, 100, 100));
  return image;
}

TEST(PixelGraph, JoinsPixelsWithinTwoOfEachOther) {
  const PixelGraph plane = pixelGraph(square(), {});
  ASSERT_EQ(plane.pixel.size(), 49u);
  const WeightedGraph& graph = plane.graph;
  EXPECT_EQ(graph.row_start[1] - graph.row_start[0], 8u);  // a corner
  const uint32_t middle = 24;
  EXPECT_EQ(graph.row_start[middle + 1] - graph.row_start[middle], 24u);
  EXPECT_EQ(weightBetween(graph, middle, middle + 2 * 7 + 2), 1.0);
  EXPECT_EQ(weightBetween(graph, middle, middle + 3), 0.0);
}

TEST(PixelGraph, RaisesTheEdgesOfPixelsInside) {
  const WeightedGraph graph = pixelGraph(square(), {false, 2.0}).graph;
  EXPECT_EQ(weightBetween(graph, 24, 25), 3.0);
  EXPECT_EQ(weightBetween(graph, 25, 24), 3.0);
  EXPECT_EQ(weightBetween(graph, 0, 1), 1.0);  // two pixels on the border
}

TEST(PixelGraph, TellsColorsApart) {
  const WeightedGraph graph = pixelGraph(square(), {true, 0.0}).graph;
  EXPECT_DOUBLE_EQ(weightBetween(graph, 24, 25), 2.0);
  EXPECT_NEAR(weightBetween(graph, 26, 27), 0.1, 1e-12);
}

/// How many of the figure's tips (head, hands, feet) lie in branches of their own.
size_t tipsApart(const PixelGraphOptions& weights, SplineTermination stop) {
  const PixelGraph plane = pixelGraph(testImage(), weights);
  SplineWalkOptions walk;
  walk.stop_radius = 0.3;
  const std::vector<int> branch =
      branchOfNodes(splinePropagationBranches(laplacianEigenmap(plane.graph, 6), stop, 5, walk),
                    plane.pixel.size());
  std::set<int> found;
  for (size_t node = 0; node < plane.pixel.size(); ++node) {
    for (const cv::Point tip : {cv::Point(44, 7), {8, 50}, {80, 50}, {26, 89}, {62, 89}})
      if (plane.pixel[node] == tip) found.insert(branch[node]);
  }
  found.erase(0);
  return found.size();
}

// As in Fig. 3-12 and 3-14: shrinking draws the head to the origin, its colour keeps it out.
TEST(PlaneFigure, HasItsLimbsInBranchesOfTheirOwn) {
  EXPECT_EQ(tipsApart({}, SplineTermination::kOutliers), 5u);
  EXPECT_EQ(tipsApart({false, 4.0}, SplineTermination::kOrigin), 4u);
  EXPECT_EQ(tipsApart({true, 4.0}, SplineTermination::kOrigin), 5u);
}

TEST(EigenmapDrawing, PutsPointsWhereTheyAreInTheirColors) {
  Eigen::MatrixXd points(2, 2);
  points << 0, 0, 1, 1;  // the second to the right and above
  const cv::Mat panel = drawPoints(points, 0.1, {branchColor(1), branchColor(2)});
  const auto at = [&](int x, int y) { return cv::Scalar(panel.at<cv::Vec3b>(y, x)); };
  EXPECT_EQ(at(26, kPanel - 26), branchColor(1));
  EXPECT_EQ(at(kPanel - 26, 26), branchColor(2));
  EXPECT_EQ(at(26, 26), cv::Scalar(255, 255, 255));
}

TEST(EigenmapDrawing, ShowsTheDimensionsAskedFor) {
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Zero(3, 6);
  vectors.row(1) << 1, 0, 0, 0, 0, 0;
  vectors.row(2) << 0, 0, 0, 0, 0, 1;
  const auto inColor = [&](int first, int branch) {
    cv::Mat mask;
    cv::inRange(drawEmbedding(vectors, first, {0, 1, 2}), branchColor(branch), branchColor(branch),
                mask);
    return cv::countNonZero(mask);
  };
  EXPECT_GT(inColor(0, 1), 5);
  EXPECT_GT(inColor(3, 2), 5);
}

}  // namespace
}  // namespace markerless_mocap
