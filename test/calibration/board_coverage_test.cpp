#include "calibration/board_coverage.h"

#include <gtest/gtest.h>

#include "calibration/board_scene.h"

namespace markerless_mocap {
namespace {

std::vector<CameraToCalibrate> camerasOf(const BoardScene& scene) {
  std::vector<CameraToCalibrate> cameras;
  for (const CameraCalibration& camera : scene.cameras)
    cameras.push_back({camera.name, camera.width, camera.height, {}});
  return cameras;
}

/// Views of all cameras at one time.
std::vector<BoardView> viewsAt(const BoardScene& scene, double time, std::mt19937* random) {
  std::vector<BoardView> views;
  for (size_t i = 0; i < scene.cameras.size(); ++i)
    if (auto view = scene.viewAt(i, time, BoardScene::boardAt(time), random))
      views.push_back(*view);
  return views;
}

TEST(BoardCoverage, WhatSufficesSufficesToCalibrate) {
  BoardScene scene;
  scene.addRing(4);
  BoardCoverage coverage(Board(scene.board), camerasOf(scene));
  CalibrationInput input = scene.input(0);
  std::mt19937 random(2);
  EXPECT_EQ(coverage.missing().front(), "cam0 needs 20 more places of the board");
  EXPECT_EQ(coverage.missing().back(),
            "show the board more often to one of cam0 and at the same time to one of cam1, cam2, "
            "cam3");
  double time = 0;
  for (; time < 300 && !coverage.missing().empty(); time += 0.25) {
    const std::vector<BoardView> views = viewsAt(scene, time, &random);
    coverage.add(views);
    input.views.insert(input.views.end(), views.begin(), views.end());
  }
  EXPECT_LT(time, 120);
  EXPECT_GT(time, 5);
  for (const CameraCoverage& camera : coverage.cameras()) {
    EXPECT_GE(camera.views, 20);
    EXPECT_GE(camera.covered(), 0.5);
  }
  const RigCalibration result = calibrateRig(input);
  EXPECT_TRUE(result.good) << result.verdict[1];
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.005);
}

TEST(BoardCoverage, ABoardThatIsHeldStillCountsOnce) {
  BoardScene scene;
  scene.addRing(2);
  BoardCoverage coverage(Board(scene.board), camerasOf(scene));
  std::mt19937 random(2);
  std::vector<BoardView> views;
  double time = 0;
  for (; views.size() < 2; time += 0.1) views = viewsAt(scene, time, &random);
  EXPECT_TRUE(coverage.add(views));
  for (int i = 0; i < 30; ++i) EXPECT_FALSE(coverage.add(views));
  EXPECT_EQ(coverage.cameras()[0].views, 1);
  EXPECT_EQ(coverage.cameras()[0].shared[1], 1);
  EXPECT_EQ(coverage.cameras()[1].shared, (std::vector<int>{1, 0}));
  EXPECT_NE(coverage.table().find("cam0           1 of 20 places"), std::string::npos);
}

TEST(BoardCoverage, PlacesThatWereNotSeenAreNamed) {
  BoardScene scene;
  scene.addRing(1);
  CoverageGoals goals;
  goals.views = 1;
  goals.tilted = 0;
  BoardCoverage coverage(Board(scene.board), camerasOf(scene), goals);
  BoardView view;  // corners all over the image but for its left third
  for (int i = 0; i < 35; ++i) {
    view.corners.ids.push_back(i);
    view.corners.pixels.emplace_back(500 + 120 * (i % 7), 100 + 190 * (i / 7));
  }
  coverage.add({view});
  EXPECT_EQ(coverage.missing().size(), 0u);
  CoverageGoals more = goals;
  more.covered = 0.7;
  BoardCoverage wanting(Board(scene.board), camerasOf(scene), more);
  wanting.add({view});
  EXPECT_EQ(
      wanting.missing(),
      (std::vector<std::string>{"cam0 has not seen the board at: upper left, left, lower left"}));
}

TEST(BoardCoverage, TiltIsToldWithoutALens) {
  BoardOptions options;
  const Board board(options);
  for (const double tilt : {0.0, 0.3, 0.7}) {
    BoardCorners corners;
    for (size_t i = 0; i < board.corners().size(); ++i) {
      corners.ids.push_back(int(i));
      const Eigen::Vector2d& at = board.corners()[i];
      corners.pixels.emplace_back(1000 * at.x(), 1000 * at.y() * std::cos(tilt));
    }
    EXPECT_NEAR(tiltOf(board, corners), tilt, 1e-6);
  }
}

}  // namespace
}  // namespace markerless_mocap
