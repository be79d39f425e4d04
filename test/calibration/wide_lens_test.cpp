#include <gtest/gtest.h>

#include "calibration/board_scene.h"
#include "calibration/calibrate.h"
#include "calibration/origin/world_frame.h"

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180;

/// A ring that sees 160 to 180 degrees across its images; the last camera is an ordinary one.
BoardScene wideScene() {
  BoardScene scene;
  scene.addRing(5, 2.6);
  for (size_t i = 0; i + 1 < scene.cameras.size(); ++i) {
    CameraCalibration& camera = scene.cameras[i];
    const double focal = 410 + 15 * double(i);
    camera.K(0, 0) = focal;
    camera.K(1, 1) = 1.004 * focal;
    camera.D = {-0.02 + 0.01 * double(i), 0.004, -0.001, 0.0003};
    camera.lens = LensType::kFisheye;
  }
  return scene;
}

std::string trialsOf(const CalibratedCamera& camera) {
  std::string text;
  for (const LensTrial& one : camera.lens_trials)
    text += ", " + nameOf(one.lens) + ": " + std::to_string(one.rms);
  return text;
}

TEST(WideLenses, FisheyesAreToldFromOthersAndEstimated) {
  const BoardScene scene = wideScene();
  const RigCalibration result = calibrateRig(scene.input(40));
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    const bool wide = i + 1 < scene.cameras.size();
    const CalibratedCamera& camera = result.cameras[i];
    EXPECT_EQ(nameOf(camera.lens), wide ? "fisheye" : "k1 k2 p1 p2") << i << trialsOf(camera);
    EXPECT_EQ(camera.calibration.lens, scene.cameras[i].lens) << i;
    EXPECT_NEAR(camera.calibration.K(0, 0) / scene.cameras[i].K(0, 0), 1.0, 0.002) << i;
  }
  const RigError error = rigError(result, scene.cameras);
  EXPECT_LT(error.largestPosition(), 0.002);
  EXPECT_LT(error.largestDirection(), 0.05 * kDegree);
  EXPECT_NEAR(result.rms, 0.3 * std::sqrt(2.0), 0.02);
  EXPECT_TRUE(result.good) << result.verdict[1];
}

TEST(WideLenses, FisheyesThatAreGivenAreKept) {
  const BoardScene scene = wideScene();
  CalibrationInput input = scene.input(20);
  for (size_t i = 0; i < scene.cameras.size(); ++i) input.cameras[i].given = scene.cameras[i];
  const RigCalibration result = calibrateRig(input);
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    EXPECT_EQ(result.cameras[i].calibration.lens, scene.cameras[i].lens) << i;
    EXPECT_EQ(result.cameras[i].calibration.K, scene.cameras[i].K) << i;
    EXPECT_EQ(result.cameras[i].calibration.D, scene.cameras[i].D) << i;
  }
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.002);
}

TEST(WideLenses, KnownPointsPlaceFisheyes) {
  const CameraCalibration fisheye = wideScene().cameras[0];
  RigState state;
  state.cameras.resize(1);
  state.cameras[0].lens = LensModel::kFisheye;
  state.cameras[0].intrinsics = intrinsicsOf(fisheye);
  for (int k = 0; k < 12; ++k) {
    const double angle = (10 + 5 * k) * kDegree;  // from the axis
    const Eigen::Vector3d ray(std::sin(angle) * std::cos(2.0 * k),
                              std::sin(angle) * std::sin(2.0 * k), std::cos(angle));
    KnownPoint point;
    point.position = fisheye.T_world_camera * ((1.5 + 0.2 * k) * ray);
    if (const auto pixel = Camera(fisheye).project(point.position))
      point.pixels.emplace_back(0, *pixel);
    state.points.push_back(point);
  }
  const auto pose = posesByPoints(state).at(0);
  ASSERT_TRUE(pose);
  EXPECT_TRUE(pose->isApprox(fisheye.T_world_camera.inverse(), 1e-4));
}

}  // namespace
}  // namespace markerless_mocap
