#include "camera/camera_difference.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

CameraCalibration calibration() {
  CameraCalibration camera;
  camera.name = "a";
  camera.width = 640;
  camera.height = 480;
  camera.K << 500, 0, 320, 0, 500, 240, 0, 0, 1;
  camera.T_world_camera.translation() = Eigen::Vector3d(1.0, 2.0, 3.0);
  return camera;
}

bool differs(const CameraCalibration& other) {
  return seeDifferently(Camera(calibration()), Camera(other));
}

TEST(CameraDifference, NoiseOfAPoseOrALensIsNone) {
  CameraCalibration other = calibration();
  EXPECT_FALSE(differs(other));
  other.T_world_camera.translation().x() += 0.008;
  other.K(0, 0) += 0.5;
  other.D = {0.001, 0.0, 0.0, 0.0};
  EXPECT_FALSE(differs(other));
}

TEST(CameraDifference, APlaceATurnALensOrASizeIsOne) {
  CameraCalibration other = calibration();
  other.T_world_camera.translation().z() -= 0.02;
  EXPECT_TRUE(differs(other));
  other = calibration();
  other.T_world_camera.rotate(Eigen::AngleAxisd(0.005, Eigen::Vector3d::UnitZ()));
  EXPECT_TRUE(differs(other));
  other = calibration();
  other.K(0, 0) *= 1.03;
  EXPECT_TRUE(differs(other));
  other = calibration();
  other.D = {-0.1, 0.0, 0.0, 0.0};
  EXPECT_TRUE(differs(other));
  other = calibration();
  other.height = 481;
  EXPECT_TRUE(differs(other));
}

}  // namespace
}  // namespace markerless_mocap
