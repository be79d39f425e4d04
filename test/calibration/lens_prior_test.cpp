#include "calibration/adjust/lens_prior.h"

#include <gtest/gtest.h>

#include <random>

#include "calibration/board_scene.h"

namespace markerless_mocap {
namespace {

/// A small board amid the images of webcams that read a row after the other: the corners of a view
/// share an error of some pixels.
CalibrationInput rollingWebcams(const BoardScene& scene, double seconds) {
  constexpr double kPerRow = 0.025 / 960;  // s
  CalibrationInput input = scene.input(seconds);
  const Board board(scene.board);
  std::mt19937 random(scene.seed + 50);
  std::normal_distribution<double> error(0.0, scene.noise);
  std::vector<BoardView> views;
  for (BoardView view : input.views) {
    const Camera camera(scene.cameras[view.camera]);
    bool amid = true;
    for (size_t k = 0; k < view.corners.ids.size(); ++k) {
      Eigen::Vector2d& pixel = view.corners.pixels[k];
      amid &= std::abs(pixel.x() - 640) < 400 && std::abs(pixel.y() - 480) < 320;
      Eigen::Vector3d place;
      place << board.corners()[view.corners.ids[k]], 0;
      const double late = (pixel.y() - 480) * kPerRow;
      if (const auto moved = camera.project(BoardScene::boardAt(view.time + late) * place))
        pixel = *moved + Eigen::Vector2d(error(random), error(random));
    }
    if (amid) views.push_back(view);
  }
  input.views = views;
  return input;
}

/// Root mean squares over cameras and recordings.
struct Errors {
  double centre = 0, direction = 0;  ///< pixels, degrees
};

Errors errorsOfRollingWebcams() {
  Errors errors;
  int cameras = 0;
  for (unsigned seed = 1; seed <= 3; ++seed) {
    BoardScene scene;
    scene.addRing(4);
    scene.seed = seed;
    scene.rate = 4;
    scene.board.square = 0.05;
    scene.board.marker = 0.037;
    const RigCalibration result = calibrateRig(rollingWebcams(scene, 30));
    const RigError error = rigError(result, scene.cameras);
    for (size_t i = 0; i < scene.cameras.size(); ++i, ++cameras) {
      const Eigen::Matrix3d K = result.cameras[i].calibration.K - scene.cameras[i].K;
      errors.centre += K.block<2, 1>(0, 2).squaredNorm();
      errors.direction += error.direction[i].squaredNorm();
    }
  }
  return {std::sqrt(errors.centre / cameras), std::sqrt(errors.direction / cameras) * 180 / M_PI};
}

TEST(LensPrior, AxisStaysNearTheMiddleIfViewsOfASmallPartShareErrors) {
  const Errors errors = errorsOfRollingWebcams();
  RecordProperty("centre", std::to_string(errors.centre));
  RecordProperty("direction", std::to_string(errors.direction));
  EXPECT_LT(errors.centre, 22);  // 24 if nothing is known of lenses
  EXPECT_LT(errors.direction, 1.15);
}

TEST(LensPrior, KnowsNothingOfTheAxisOfAnImageOfUnknownSize) {
  CameraState camera;
  EXPECT_TRUE(std::isinf(commonLens(camera, 0.3).sigma[2]));
  camera.size << 1281, 721;
  const LensPrior prior = commonLens(camera, 0.3);
  EXPECT_EQ(prior.mean[2], 640);
  EXPECT_EQ(prior.mean[3], 360);
  EXPECT_TRUE(std::isinf(prior.sigma[0]));
  EXPECT_LT(prior.sigma[6], 0.01);
  camera.lens = LensModel::kFisheye;
  EXPECT_GT(commonLens(camera, 0.3).sigma[6], 1);
}

}  // namespace
}  // namespace markerless_mocap
