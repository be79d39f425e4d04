#include "markerless_mocap/capture/renderer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "markerless_mocap/capture/camera_ring.h"

namespace markerless_mocap {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kFocal = 200.0;

/// At the height of 1 m, 3 m from the z axis, looking along -x.
Camera camera(std::vector<double> D = {}) {
  CameraCalibration c;
  c.name = "test";
  c.width = 200;
  c.height = 160;
  c.K << kFocal, 0, 99.5, 0, kFocal, 79.5, 0, 0, 1;
  c.D = std::move(D);
  c.T_world_camera = lookAt({3, 0, 1}, {0, 0, 1});
  return Camera(c);
}

SolidCone ball(const Eigen::Vector3d& center, double radius, const Eigen::Vector3f& rgb) {
  return {center, center, radius, radius, rgb};
}

const Eigen::Vector3f kRed(1, 0, 0), kBlue(0, 0, 1);

/// Whether the ray through a pixel meets any of many spheres along the cone; `slack` grows them.
bool meets(const Camera& cam, int x, int y, const SolidCone& cone, double slack) {
  const Eigen::Vector3d eye = cam.position(), ray = cam.rayDirection({double(x), double(y)});
  for (int i = 0; i <= 2000; ++i) {
    const double s = i / 2000.0;
    const Eigen::Vector3d to_center = cone.a + s * (cone.b - cone.a) - eye;
    const double radius = cone.radius_a + s * (cone.radius_b - cone.radius_a) + slack;
    if ((to_center - to_center.dot(ray) * ray).norm() <= radius) return true;
  }
  return false;
}

void expectMaskOf(const SolidCone& cone, const std::vector<double>& D) {
  const Camera cam = camera(D);
  const RenderedView view = ViewRenderer(cam).render({cone});
  ASSERT_GT(cv::countNonZero(view.mask), 300);
  int wrong = 0;
  for (int y = 0; y < cam.height(); ++y)
    for (int x = 0; x < cam.width(); ++x) {
      const bool drawn = view.mask.at<uint8_t>(y, x) != 0;
      if (drawn && !meets(cam, x, y, cone, 1e-4)) ++wrong;
      if (!drawn && meets(cam, x, y, cone, -1e-4)) ++wrong;
    }
  EXPECT_EQ(wrong, 0);
}

TEST(RendererTest, ballOnTheAxisIsADiscOfTheRightArea) {
  const ViewRenderer renderer(camera());
  const double radius = 0.5, distance = 3.0;
  const RenderedView view = renderer.render({ball({0, 0, 1}, radius, kRed)});
  const double radius_px = kFocal * radius / std::sqrt(distance * distance - radius * radius);
  EXPECT_NEAR(cv::countNonZero(view.mask), kPi * radius_px * radius_px,
              0.01 * kPi * radius_px * radius_px);
  EXPECT_NEAR(view.depth.at<float>(79, 99), distance - radius, 1e-4);
}

TEST(RendererTest, coneCoversThePixelsWhoseRaysMeetIt) {
  expectMaskOf({{0.3, -0.4, 0.7}, {-0.5, 0.5, 1.4}, 0.2, 0.2, kRed}, {});
  expectMaskOf({{0.3, -0.4, 0.7}, {-0.5, 0.5, 1.4}, 0.3, 0.1, kRed}, {});
  expectMaskOf({{0.9, 0.1, 1.1}, {-0.5, 0.1, 0.9}, 0.1, 0.4, kRed}, {});  // towards the camera
  expectMaskOf({{0.1, 0.1, 1.0}, {0.1, 0.1, 1.1}, 0.4, 0.1, kRed}, {});   // one ball in the other
}

TEST(RendererTest, lensDistortionIsHonoured) {
  expectMaskOf({{0.3, -0.9, 0.4}, {0.0, 0.8, 1.6}, 0.2, 0.1, kRed}, {-0.2, 0.05, 0.001, -0.002});
}

TEST(RendererTest, nearConeHidesTheFarOneInEitherOrder) {
  const ViewRenderer renderer(camera());
  const SolidCone near = ball({1, 0, 1}, 0.1, kRed), far = ball({-1, 0, 1}, 0.8, kBlue);
  for (const auto& cones : {std::vector{near, far}, std::vector{far, near}}) {
    const RenderedView view = renderer.render(cones);
    const cv::Vec3b center = view.image.at<cv::Vec3b>(79, 99);
    EXPECT_GT(center[2], 100);
    EXPECT_EQ(center[0], 0);
    EXPECT_EQ(view.image.at<cv::Vec3b>(79, 130)[2], 0);    // the far ball beside the near one
    EXPECT_NEAR(view.depth.at<float>(79, 99), 1.9, 1e-3);  // half a pixel off the axis
  }
}

TEST(RendererTest, lightComesFromAbove) {
  const RenderedView view = ViewRenderer(camera()).render({ball({0, 0, 1}, 0.5, kRed)});
  EXPECT_GT(view.image.at<cv::Vec3b>(55, 99)[2], view.image.at<cv::Vec3b>(105, 99)[2] + 30);
}

TEST(RendererTest, roomStaysWhereNoConeIsSeen) {
  const ViewRenderer renderer(camera());
  const RenderedView empty = renderer.render({ball({8, 0, 1}, 0.5, kRed)});  // behind the camera
  EXPECT_EQ(cv::countNonZero(empty.mask), 0);
  EXPECT_EQ(cv::norm(empty.image, renderer.background(), cv::NORM_INF), 0.0);
  const RenderedView view = renderer.render({ball({0, 0, 1}, 0.5, kRed)});
  cv::Mat outside = view.image.clone();
  renderer.background().copyTo(outside, view.mask);
  EXPECT_EQ(cv::norm(outside, renderer.background(), cv::NORM_INF), 0.0);
}

TEST(RendererTest, roomHasContrastToLearnFrom) {
  cv::Scalar mean, deviation;
  cv::meanStdDev(ViewRenderer(camera()).background(), mean, deviation);
  EXPECT_GT(deviation[1], 5.0);
  EXPECT_LT(deviation[1], 60.0);
}

}  // namespace
}  // namespace markerless_mocap
