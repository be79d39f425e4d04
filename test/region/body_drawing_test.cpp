#include "region/body_drawing.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

const cv::Size kSize(100, 80);

BodyDrawing drawn(const std::vector<ProjectedCone>& cones, int parts, float margin = 5) {
  return drawBody({cones, 2.f}, parts, kSize, margin);
}

float distanceAt(const BodyDrawing& drawing, int x, int y) {
  return drawing.distance.at<float>(y - drawing.box.y, x - drawing.box.x);
}

TEST(BodyDrawing, MeasuresDistancesToADisk) {
  const BodyDrawing drawing = drawn({{{40, 30}, {40, 30}, 10, 10, 2, 2, 0}}, 1);
  EXPECT_EQ(drawing.box, cv::Rect(25, 15, 31, 31));
  EXPECT_NEAR(distanceAt(drawing, 40, 30), -10, 1e-4);
  EXPECT_NEAR(distanceAt(drawing, 53, 30), 3, 1e-4);
  EXPECT_NEAR(distanceAt(drawing, 43, 34), -5, 1e-4);
}

TEST(BodyDrawing, MeasuresDistancesToTheTangentOfTwoDisks) {
  // Radii 10 and 4, 30 apart: the tangent leans by asin(0.2), so a point at (u, v), across and
  // along the axis, lies u cos + v sin - 10 beyond it.
  const BodyDrawing drawing = drawn({{{30, 40}, {60, 40}, 10, 4, 2, 2, 0}}, 1);
  EXPECT_NEAR(distanceAt(drawing, 45, 40), -(10 - 15 * 0.2), 1e-3);
  EXPECT_NEAR(distanceAt(drawing, 66, 40), 2, 1e-3);
  EXPECT_NEAR(distanceAt(drawing, 45, 50), std::sqrt(0.96) * 10 + 0.2 * 15 - 10, 1e-3);
}

TEST(BodyDrawing, OneDiskInsideTheOtherIsADisk) {
  const BodyDrawing drawing = drawn({{{40, 30}, {42, 30}, 3, 12, 2, 2, 0}}, 1);
  EXPECT_NEAR(distanceAt(drawing, 42, 30), -12, 1e-4);
  EXPECT_NEAR(distanceAt(drawing, 56, 30), 2, 1e-4);
}

TEST(BodyDrawing, ShowsThePartInFront) {
  const ProjectedCone behind{{40, 30}, {40, 30}, 12, 12, 3, 3, 0};
  const ProjectedCone front{{44, 30}, {44, 30}, 4, 4, 2, 2, 1};
  for (const auto& order : {std::vector{behind, front}, std::vector{front, behind}}) {
    const BodyDrawing drawing = drawn(order, 2);
    EXPECT_EQ(drawing.part.at<uchar>(30 - drawing.box.y, 44 - drawing.box.x), 1);
    EXPECT_EQ(drawing.part.at<uchar>(30 - drawing.box.y, 32 - drawing.box.x), 0);
    EXPECT_EQ(drawing.part.at<uchar>(0, 0), BodyDrawing::kNoPart);
    EXPECT_NEAR(drawing.parts[1].depth_inside, 4, 1e-4);
  }
}

TEST(BodyDrawing, DistanceWithoutPartsIsTheSame) {
  const std::vector<ProjectedCone> cones{{{30, 40}, {60, 44}, 10, 4, 2, 2, 0},
                                         {{95, 70}, {80, 60}, 3, 9, 2, 2, 1}};
  const BodyDrawing drawing = drawn(cones, 2);
  const BodyDistance body = distanceFrom({cones, 2.f}, kSize, 5);
  EXPECT_EQ(body.box, drawing.box);
  EXPECT_EQ(cv::norm(body.distance, drawing.distance, cv::NORM_INF), 0.0);
  EXPECT_EQ(distanceFrom({}, kSize, 5).box.area(), 0);
}

TEST(BodyDrawing, IsEmptyForABodyOutsideTheImage) {
  const BodyDrawing outside = drawn({{{-60, 30}, {-40, 30}, 5, 5, 2, 2, 0}}, 1);
  EXPECT_EQ(outside.box.area(), 0);
  const float nan = std::nanf("");
  EXPECT_EQ(drawn({{{nan, 30}, {40, 30}, 5, 5, 2, 2, 0}}, 1).box.area(), 0);
}

}  // namespace
}  // namespace markerless_mocap
