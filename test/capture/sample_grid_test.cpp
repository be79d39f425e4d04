#include "capture/render/sample_grid.h"

#include <gtest/gtest.h>

#include <random>

#include "capture/mesh_fixture.h"

namespace markerless_mocap {
namespace {

TEST(SampleGridTest, pointsFallWhereTheCameraProjectsThem) {
  const Camera camera = sideCamera(kLens);
  const SampleGrid grid(camera);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> fraction(-1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const Eigen::Vector3d point(fraction(random), 0.8 * fraction(random),
                                1.0 + 0.6 * fraction(random));
    const auto pixel = camera.project(point);
    ASSERT_TRUE(pixel);
    const Eigen::Vector2d place = grid.place(grid.worldToCamera() * point);
    EXPECT_LT((place - (2.0 * *pixel + Eigen::Vector2d::Ones())).norm(), 1e-9);
  }
}

TEST(SampleGridTest, oddPlacesAreTheRaysOfPixelCentres) {
  const Camera camera = sideCamera(kLens);
  const SampleGrid grid(camera);
  EXPECT_EQ(grid.size(), cv::Size(321, 241));
  for (const cv::Point pixel : {cv::Point(0, 0), cv::Point(80, 60), cv::Point(159, 30)}) {
    const Eigen::Vector3d ray =
        grid.worldToCamera().linear() * camera.rayDirection({double(pixel.x), double(pixel.y)});
    const Eigen::Vector2f plane = grid.row(2 * pixel.y + 1)[2 * pixel.x + 1];
    EXPECT_LT((plane.cast<double>() - ray.hnormalized()).norm(), 1e-6);
  }
}

TEST(SampleGridTest, pointsBehindTheCameraOrFarAsideHaveNoPlace) {
  const SampleGrid grid(sideCamera(kLens));
  EXPECT_TRUE(grid.place({0, 0, -1}).hasNaN());
  EXPECT_TRUE(grid.place({0, 0, 0}).hasNaN());
  EXPECT_TRUE(grid.place({3, 0, 1}).hasNaN());
}

TEST(SampleGridTest, marginHoldsHowFarLensesBendStraightLines) {
  const SampleGrid grid(sideCamera(kLens));
  const Eigen::Vector3d a(-0.45, 0.3, 1.0), b(0.4, 0.35, 1.0);
  const Eigen::Vector2d from = grid.place(a), to = grid.place(b);
  const double margin = grid.margin((b - a).norm());
  double bend = 0.0;
  for (double t = 0.0; t <= 1.0; t += 0.01)
    bend = std::max(bend, (grid.place(a + t * (b - a)) - (from + t * (to - from))).norm());
  EXPECT_GT(bend, 2.0);
  EXPECT_LT(bend, margin);
  const SampleGrid straight(sideCamera());
  EXPECT_NEAR(straight.margin(1.0), 0.0, 1e-3);
}

TEST(SampleGridTest, placesWithinABoxAreFound) {
  const SampleGrid grid(sideCamera(kLens));
  const Eigen::Vector2d low(-0.1, 0.05), high(0.2, 0.15);
  const cv::Rect places = grid.placesWithin(low, high);
  for (int y = 0; y < grid.size().height; ++y)
    for (int x = 0; x < grid.size().width; ++x) {
      const Eigen::Array2d point = grid.row(y)[x].cast<double>().array();
      const bool within = (point >= low.array()).all() && (point <= high.array()).all();
      ASSERT_TRUE(!within || places.contains({x, y}));
    }
  EXPECT_LT(places.area(), 20000);
  EXPECT_TRUE(grid.placesWithin({2, 2}, {3, 3}).empty());
}

}  // namespace
}  // namespace markerless_mocap
