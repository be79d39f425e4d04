#include "markerless_mocap/capture/camera_ring.h"

#include <gtest/gtest.h>

#include "capture/studio_fixture.h"

namespace markerless_mocap {
namespace {

TEST(CameraRingTest, everyCameraLooksAtTheCentreUpright) {
  StudioOptions options;
  options.overhead = false;
  options.cameras = 5;
  const CameraRig rig = cameraRing(options);
  ASSERT_EQ(rig.size(), 5u);
  for (const Camera& camera : rig) {
    const auto center = camera.project(ringTarget());
    ASSERT_TRUE(center);
    EXPECT_TRUE(center->isApprox(Eigen::Vector2d(319.5, 239.5), 1e-9));
    EXPECT_LT(camera.project(ringTarget() + Eigen::Vector3d(0, 0, 0.5))->y(), center->y());
    EXPECT_NEAR(camera.position().head<2>().norm(), options.ring_radius, 1e-12);
    EXPECT_EQ(camera.position().z(), options.ring_height);
  }
  EXPECT_EQ(rig[0].name(), "cam0");
  EXPECT_GT(rig[0].position().x(), 0.0);
  EXPECT_GT(rig[1].position().y(), 0.0);  // counter-clockwise
}

TEST(CameraRingTest, lastCameraHangsAboveTheCentre) {
  const CameraRig rig = cameraRing(StudioOptions());
  const Camera& top = rig.back();
  EXPECT_EQ(top.position(), Eigen::Vector3d(0, 0, 4.0));
  EXPECT_TRUE(top.project(ringTarget())->isApprox(Eigen::Vector2d(319.5, 239.5), 1e-9));
  EXPECT_LT(top.project({1, 0, 1})->y(), 200.0);  // x is up in its image
  EXPECT_LT(top.project({0, 1, 1})->x(), 300.0);  // and y to the left
}

TEST(CameraRingTest, fieldOfViewSpansTheImage) {
  StudioOptions options;
  options.horizontal_view_deg = 90.0;
  const Camera camera = cameraRing(options)[0];
  // Half the width, 320 pixels, lies at 45 degrees.
  EXPECT_NEAR(camera.calibration().K(0, 0), 320.0, 1e-9);
}

TEST(CameraRingTest, cameraAtItsTargetIsRefused) {
  EXPECT_EQ(sentenceOf([] {
              lookAt({1, 2, 3}, {1, 2, 3});
            }),
            "a camera cannot look at the point where it is");
}

TEST(CameraRingTest, optionsOutOfRangeAreNamed) {
  StudioOptions options;
  options.cameras = 1;
  EXPECT_EQ(sentenceOf([&] { cameraRing(options); }),
            "virtual_studio/cameras is 1, allowed is 2 to 32");
}

}  // namespace
}  // namespace markerless_mocap
