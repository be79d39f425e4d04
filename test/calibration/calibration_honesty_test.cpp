#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "calibration/board_scene.h"

namespace markerless_mocap {
namespace {

/// Squares of errors in units of their stated standard deviations.
struct Honesty {
  double position = 0, direction = 0, focal = 0;
  int cameras = 0;

  void add(const CalibratedCamera& found, const CameraCalibration& truth,
           const Eigen::Vector3d& position_error, const Eigen::Vector3d& direction_error) {
    position += position_error.cwiseQuotient(found.position_sigma).squaredNorm() / 3;
    direction += direction_error.cwiseQuotient(found.direction_sigma).squaredNorm() / 3;
    const double off = found.calibration.K(0, 0) - truth.K(0, 0);
    focal += off * off / (found.focal_sigma.x() * found.focal_sigma.x());
    ++cameras;
  }

  void expect() const {
    for (const auto& [name, sum] :
         {std::pair("position", position), {"direction", direction}, {"focal", focal}}) {
      EXPECT_GT(std::sqrt(sum / cameras), 0.7) << name;
      EXPECT_LT(std::sqrt(sum / cameras), 1.4) << name;
    }
  }
};

/// Points of a room, whose pixels are read off with an error, in the images of all cameras.
std::vector<KnownPoint> pointsByEye(const BoardScene& scene, double noise, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> error(0.0, noise);
  std::vector<KnownPoint> points;
  for (int k = 0; k < 10; ++k) {
    KnownPoint point;
    point.name = std::to_string(k);
    point.position << 1.3 * std::cos(2.4 * k), 1.3 * std::sin(2.4 * k), 0.9 * (k % 3);
    for (size_t i = 0; i < scene.cameras.size(); ++i)
      if (const auto pixel = Camera(scene.cameras[i]).projectInside(point.position)) {
        const double u = pixel->x() + error(random), v = pixel->y() + error(random);
        point.pixels.emplace_back(i, Eigen::Vector2d(u, v));
      }
    points.push_back(point);
  }
  return points;
}

/// Cameras whose lens is known from pictures of a board, and whose place from points by eye.
Honesty honestyOfPoints(double noise, double seconds, double rate) {
  Honesty honesty;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    BoardScene scene;
    scene.addRing(4);
    scene.seed = seed;
    scene.rate = rate;
    CalibrationInput input = scene.input(seconds);
    for (BoardView& view : input.views) view.alone = true;
    input.points = pointsByEye(scene, noise, seed + 100);
    const RigCalibration result = calibrateRig(input);
    for (size_t i = 0; i < scene.cameras.size(); ++i) {
      const CalibratedCamera& found = result.cameras[i];
      const CameraCalibration& truth = scene.cameras[i];
      // In the axes of the true camera.
      const Eigen::Isometry3d off =
          truth.T_world_camera.inverse() * found.calibration.T_world_camera;
      const Eigen::AngleAxisd turn(off.linear());
      honesty.add(found, truth, off.translation(), turn.angle() * turn.axis());
    }
  }
  return honesty;
}

TEST(CalibrationHonesty, PointsByEyeAndManyViewsOfTheBoard) {
  honestyOfPoints(5.0, 40, 2).expect();
}

TEST(CalibrationHonesty, PointsByEyeAndLensesFromFewPictures) {
  for (const double noise : {3.0, 10.0}) {
    SCOPED_TRACE(noise);
    honestyOfPoints(noise, 40, 0.5).expect();
  }
}

TEST(CalibrationHonesty, BoardSeenInASmallPartOfTheImage) {
  Honesty honesty;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    BoardScene scene;
    scene.addRing(4);
    scene.seed = seed;
    scene.rate = 4;
    scene.board.square = 0.04;
    scene.board.marker = 0.03;
    CalibrationInput input = scene.input(40);
    auto& views = input.views;
    // Only where the board is amid the image.
    views.erase(std::remove_if(views.begin(), views.end(),
                               [](const BoardView& view) {
                                 for (const Eigen::Vector2d& p : view.corners.pixels)
                                   if (std::abs(p.x() - 640) > 260 || std::abs(p.y() - 480) > 200)
                                     return true;
                                 return false;
                               }),
                views.end());
    const RigCalibration result = calibrateRig(input);
    const RigError error = rigError(result, scene.cameras);
    for (size_t i = 0; i < scene.cameras.size(); ++i) {
      const CalibratedCamera& found = result.cameras[i];
      honesty.add(found, scene.cameras[i], error.position[i], error.direction[i]);
    }
  }
  honesty.expect();
}

}  // namespace
}  // namespace markerless_mocap
