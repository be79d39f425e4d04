#include "studies/eigenmap_figures/eigenmap_figures.h"

#include <opencv2/imgcodecs.hpp>
#include <set>

#include "ros/hull_conversions.h"
#include "segmentation/eigenmap.h"
#include "segmentation/spline_propagation.h"
#include "segmentation/voxel_figure.h"
#include "studies/eigenmap_figures/eigenmap_drawing.h"
#include "studies/eigenmap_figures/eigenmap_test_image.h"
#include "tools/common/bag_io.h"
#include "tools/tool_fixture.h"

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
  const std::vector<int> branch =
      branchOfNodes(splinePropagationBranches(laplacianEigenmap(plane.graph, 6), stop, 5, 0.3),
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

using EigenmapFiguresTool = ToolTest;

TEST_F(EigenmapFiguresTool, DrawsTheTestImageAlone) {
  EigenmapFigureOptions what;
  what.folder = path("figures");
  const std::vector<std::string> files = drawEigenmapFigures(what);
  ASSERT_EQ(files.size(), 3u);
  for (const std::string& file : files) EXPECT_EQ(cv::imread(file).cols, 4 * kPanel) << file;
}

TEST_F(EigenmapFiguresTool, DrawsHullsOfABag) {
  {
    BagWriter bag(path("hulls.bag"));
    for (int i = 0; i < 2; ++i) {
      const VisualHull hull = standingFigure(1.0 + 0.03 * i).hull();
      std_msgs::Header header;
      header.frame_id = "world";
      header.stamp = ros::Time(1.0 + 0.1 * i);
      bag.write("/hull/grid", header.stamp, messageFromLattice(hull.lattice, header));
      bag.write("/hull/points", header.stamp, messageFromHull(hull, header));
    }
    bag.commit();
  }
  EigenmapFigureOptions what;
  what.folder = path("figures");
  what.input = path("hulls.bag");
  what.frame_sets = 5;  // there are two
  ASSERT_EQ(hullsOf(what).size(), 2u);
  EXPECT_EQ(drawEigenmapFigures(what).size(), 3u + 2u * 3u);
  const cv::Mat first = cv::imread(path("figures/hull_modified_0.png"));
  const cv::Mat second = cv::imread(path("figures/hull_modified_1.png"));
  ASSERT_EQ(first.size(), second.size());
  cv::Mat ink;
  cv::inRange(first(cv::Rect(0, 30, kPanel, kPanel - 10)), branchColor(1), branchColor(1), ink);
  EXPECT_GT(cv::countNonZero(ink), 20);
  EigenmapFigureOptions bad = what;
  bad.folder = path("hulls.bag");
  EXPECT_EQ(errorTextOf<std::exception>([&] { drawEigenmapFigures(bad); }),
            "cannot make the folder " + path("hulls.bag"));
  what.at = 5.0;
  EXPECT_EQ(errorTextOf<std::exception>([&] { hullsOf(what); }),
            "the bag has no hull with voxels on /hull/points from that time on");
}

}  // namespace
}  // namespace markerless_mocap
