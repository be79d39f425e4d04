#include <gtest/gtest.h>

#include <opencv2/core.hpp>

#include "capture/mesh_fixture.h"

namespace markerless_mocap {
namespace {

const TexturedRoom kRoom(1, 5, 5, 3.2);
const Eigen::Vector3f kBall(-2, 0, 0.5f);

/// A red ball above the floor, without shadows.
RenderedView redBall(double reflection) {
  static const ColoredMesh mesh = ball(20, {1, 0, 0});
  const MeshRenderer renderer(sideCamera(), kRoom, reflection);
  return renderer.render(LitScene(kRoom, {placed(mesh, 0.2f, kBall)}, 0.0));
}

/// Pixel of a world point, as seen from the side.
cv::Point pixelOf(const Eigen::Vector3d& point) {
  const Eigen::Vector2d pixel = *sideCamera().project(point);
  return {int(std::lround(pixel.x())), int(std::lround(pixel.y()))};
}

TEST(FloorMirrorTest, ballIsSeenBelowTheFloor) {
  const cv::Vec3b dull = redBall(0.0).image.at<cv::Vec3b>(pixelOf({-2, 0, -0.5}));
  const cv::Vec3b glossy = redBall(0.5).image.at<cv::Vec3b>(pixelOf({-2, 0, -0.5}));
  const auto redness = [](const cv::Vec3b& color) {
    return color[2] - (color[0] + color[1]) / 2.0;
  };
  EXPECT_GT(redness(glossy), redness(dull) + 50.0);
}

TEST(FloorMirrorTest, reflectionsReplaceThoseOfTheRoom) {
  const MeshRenderer renderer(sideCamera(), kRoom, 1.0);
  static const ColoredMesh black = ball(20, {0, 0, 0});
  const RenderedView view = renderer.render(LitScene(kRoom, {placed(black, 0.2f, kBall)}, 0.0));
  EXPECT_EQ(view.image.at<cv::Vec3b>(pixelOf({-2, 0, -0.5})), cv::Vec3b(0, 0, 0));
  // Beside the ball the full mirror shows the wall behind it.
  const cv::Point beside = pixelOf({-2, 0.6, -0.5});
  EXPECT_EQ(view.image.at<cv::Vec3b>(beside), renderer.background().at<cv::Vec3b>(beside));
}

TEST(FloorMirrorTest, wallsStayAsTheyAre) {
  const cv::Mat dull = MeshRenderer(sideCamera(), kRoom).background();
  const cv::Mat glossy = MeshRenderer(sideCamera(), kRoom, 0.5).background();
  const cv::Rect wall(0, 0, 160, 60);  // above the horizon
  EXPECT_EQ(cv::norm(dull(wall), glossy(wall), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(dull, glossy, cv::NORM_INF), 10.0);
}

TEST(FloorMirrorTest, floorMirrorsMoreAtALowAngle) {
  const cv::Mat dull = MeshRenderer(sideCamera(), kRoom).background();
  const cv::Mat glossy = MeshRenderer(sideCamera(), kRoom, 0.02).background();
  cv::Mat apart;
  cv::absdiff(dull, glossy, apart);
  const int far = pixelOf({-3.5, 0, 0}).y, near = pixelOf({0.4, 0, 0}).y;
  EXPECT_GT(cv::mean(apart.row(far))[1], 2.0 * cv::mean(apart.row(near))[1]);
}

TEST(FloorMirrorTest, masksAndDepthAreThoseOfADullFloor) {
  const RenderedView dull = redBall(0.0), glossy = redBall(0.5);
  EXPECT_EQ(cv::norm(dull.mask, glossy.mask, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::countNonZero(dull.depth != glossy.depth), 0);
}

}  // namespace
}  // namespace markerless_mocap
