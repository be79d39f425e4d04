#include "calibration/calibrate.h"

#include <glog/logging.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "calibration/board_scene.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

constexpr double kDegree = M_PI / 180;

/// What Ceres says of steps that it cannot compute.
class Warnings : public google::LogSink {
 public:
  Warnings() { google::AddLogSink(this); }
  ~Warnings() override { google::RemoveLogSink(this); }
  void send(google::LogSeverity, const char*, const char*, int, const google::LogMessageTime&,
            const char* message, size_t length) override {
    text.append(message, length).push_back('\n');
  }
  std::string text;
};

TEST(Calibrate, EightCamerasFromNoisyCorners) {
  const Warnings warnings;
  BoardScene scene;
  scene.addRing(8);
  const RigCalibration result = calibrateRig(scene.input(60));
  const RigError error = rigError(result, scene.cameras);
  EXPECT_LT(error.largestPosition(), 0.002);
  EXPECT_LT(error.largestDirection(), 0.05 * kDegree);
  for (size_t i = 0; i < scene.cameras.size(); ++i) {
    const Eigen::Matrix3d &found = result.cameras[i].calibration.K, &truth = scene.cameras[i].K;
    EXPECT_NEAR(found(0, 0) / truth(0, 0), 1.0, 0.001) << i;
    EXPECT_NEAR(found(1, 1) / truth(1, 1), 1.0, 0.001) << i;
    EXPECT_FALSE(result.cameras[i].loose) << i;
  }
  EXPECT_NEAR(result.rms, 0.3 * std::sqrt(2.0), 0.02);
  EXPECT_TRUE(result.good) << result.verdict[1];
  EXPECT_EQ(warnings.text, "");
}

TEST(Calibrate, UncertaintyIsAsLargeAsTheErrors) {
  double position = 0, direction = 0, focal = 0;
  int cameras = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    BoardScene scene;
    scene.addRing(4);
    scene.seed = seed;
    CalibrationInput input = scene.input(15);
    input.lens = LensModel::kTangential;
    const RigCalibration result = calibrateRig(input);
    const RigError error = rigError(result, scene.cameras);
    for (size_t i = 0; i < scene.cameras.size(); ++i, ++cameras) {
      const CalibratedCamera& camera = result.cameras[i];
      position += error.position[i].cwiseQuotient(camera.position_sigma).squaredNorm() / 3;
      direction += error.direction[i].cwiseQuotient(camera.direction_sigma).squaredNorm() / 3;
      const double off = camera.calibration.K(0, 0) - scene.cameras[i].K(0, 0);
      focal += off * off / (camera.focal_sigma.x() * camera.focal_sigma.x());
    }
  }
  for (const double sum : {position, direction, focal}) {
    EXPECT_GT(std::sqrt(sum / cameras), 0.7);
    EXPECT_LT(std::sqrt(sum / cameras), 1.4);
  }
  RecordProperty("position", std::to_string(std::sqrt(position / cameras)));
}

TEST(Calibrate, LooseCameraIsNamedAndItsLaterViewsAreLeftOut) {
  BoardScene scene;
  scene.addRing(5);
  scene.loose = 3;
  scene.loose_from = 26;
  const RigCalibration result = calibrateRig(scene.input(40));
  for (int i = 0; i < 5; ++i) EXPECT_EQ(result.cameras[i].loose.has_value(), i == 3) << i;
  ASSERT_TRUE(result.cameras[3].loose);
  EXPECT_GT(result.cameras[3].loose->time, 25.0);  // the next views that others share begin later
  EXPECT_LT(result.cameras[3].loose->time, 32.0);
  EXPECT_TRUE(result.cameras[3].loose->later_part);
  EXPECT_FALSE(result.good);
  EXPECT_EQ(result.verdict[1].substr(0, 13), "cam3 is loose");
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.003);
}

TEST(Calibrate, CamerasThatNeverShareAViewAreLinkedOverOthers) {
  BoardScene scene;
  scene.addRing(4);
  CalibrationInput input = scene.input(40);
  // Cameras 0 and 2 keep only what they do not see at the same time.
  const auto sees = [&](size_t camera, double time) {
    return std::any_of(input.views.begin(), input.views.end(), [&](const BoardView& view) {
      return view.camera == camera && view.time == time;
    });
  };
  CalibrationInput apart = input;
  apart.views.clear();
  for (const BoardView& view : input.views)
    if (view.camera != 2 || !sees(0, view.time)) apart.views.push_back(view);
  const RigCalibration result = calibrateRig(apart);
  for (const SharedViews& pair : result.pairs) EXPECT_FALSE(pair.a == 0 && pair.b == 2);
  const RigError error = rigError(result, scene.cameras);
  EXPECT_LT(error.largestPosition(), 0.003);
  EXPECT_LT(error.largestDirection(), 0.1 * kDegree);
}

TEST(Calibrate, TimeOffsetsOfUnsynchronisedCameras) {
  BoardScene scene;
  scene.addRing(4);
  scene.offsets = {0.0, 0.237, -0.461, 1.128};
  CalibrationInput input = scene.input(30);
  input.estimate_offsets = true;
  const RigCalibration result = calibrateRig(input);
  const double reference = result.cameras[0].time_offset;
  for (size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(result.cameras[i].time_offset - reference, scene.offsets[i], 0.005) << i;
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.004);
}

TEST(Calibrate, StampsThatAreNotQuiteTogetherAreKept) {
  BoardScene scene;
  scene.addRing(4);
  CalibrationInput input = scene.input(25);
  // Each camera exposes at other times, and says so.
  std::mt19937 random(5);
  for (BoardView& view : input.views) {
    const double later = 0.011 * double(view.camera);
    if (auto moved = scene.viewAt(view.camera, view.time + later,
                                  BoardScene::boardAt(view.time + later), &random))
      view = *moved;
  }
  const RigCalibration result = calibrateRig(input);
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.003);
  for (const CalibratedCamera& camera : result.cameras) EXPECT_EQ(camera.time_offset, 0.0);
}

TEST(Calibrate, StampsThatAreLateAreFoundAndTold) {
  BoardScene scene;
  scene.addRing(4);
  scene.offsets = {0.0, -0.04, 0.0, 0.0};
  CalibrationInput input = scene.input(30);
  input.check_clocks = true;
  const RigCalibration result = calibrateRig(input);
  EXPECT_TRUE(result.clocks_corrected);
  EXPECT_NEAR(result.cameras[1].time_offset - result.cameras[0].time_offset, -0.04, 0.005);
  EXPECT_EQ(result.verdict[1],
            "The stamps of cam1 are 40 ms later than the middle one of all cameras, by the motion "
            "of the board. That was corrected "
            "here; correct it in recordings, too.");
  EXPECT_EQ(result.cameras[1].calibration.time_offset, 0.0);
  input.clocks_last = true;
  const RigCalibration kept = calibrateRig(input);
  EXPECT_NEAR(kept.cameras[1].calibration.time_offset, -0.04, 0.005);
  EXPECT_NEAR(kept.cameras[2].calibration.time_offset, 0.0, 0.005);
  EXPECT_EQ(kept.verdict[1],
            "The stamps of cam1 are 40 ms later than the middle one of all cameras, by the motion "
            "of the board. The rig file "
            "corrects it (time_offset).");
  scene.offsets[1] = 0.0;
  input = scene.input(30);
  input.check_clocks = true;
  EXPECT_FALSE(calibrateRig(input).clocks_corrected);
}

TEST(Calibrate, SimplestLensThatPredictsViewsLeftOut) {
  BoardScene scene;
  scene.addRing(2);
  scene.cameras[0].D = {-0.2, 0, 0, 0};
  scene.cameras[1].D = {-0.45, 0.4, 0.004, -0.003, -0.25};
  const RigCalibration result = calibrateRig(scene.input(60));
  EXPECT_EQ(nameOf(result.cameras[0].lens), "k1 k2 p1 p2");
  EXPECT_GE(coefficientsOf(result.cameras[1].lens), 5);
  EXPECT_EQ(result.cameras[1].lens_trials.size(), kLensModels.size());
}

TEST(Calibrate, FloorIsWhereTheBoardLay) {
  BoardScene scene;
  scene.addRing(3);
  CalibrationInput input = scene.input(40);
  std::mt19937 random(3);
  Eigen::Isometry3d floor = Eigen::Isometry3d::Identity();
  floor.translation() << 0.3, -0.2, 0.01;
  floor.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitZ()));
  for (size_t i = 0; i < 3; ++i)
    if (auto view = scene.viewAt(i, 60.0, floor, &random)) input.views.push_back(*view);
  input.floor = FloorView{1, 60.0, 0.01};
  const RigCalibration result = calibrateRig(input);
  EXPECT_TRUE(result.floor_known);
  // A plane of 0.8 x 0.6 m is extended over 4 m.
  Eigen::Isometry3d world = floor;
  world.translation().z() -= 0.01;
  for (size_t i = 0; i < 3; ++i) {
    const Eigen::Isometry3d wanted = world.inverse() * scene.cameras[i].T_world_camera;
    EXPECT_LT(
        (result.cameras[i].calibration.T_world_camera.translation() - wanted.translation()).norm(),
        0.015);
  }
}

/// A plank of 0.28 x 0.1 x 1.8 m that stands in places all over the room.
std::vector<SilhouetteSet> planksThatStand(const std::vector<CameraCalibration>& cameras) {
  std::vector<SilhouetteSet> sets;
  for (int k = 0; k < 14; ++k) {
    SilhouetteSet set;
    for (const CameraCalibration& camera : cameras) {
      set.emplace_back(camera.height, camera.width, CV_8UC1, cv::Scalar(0));
      std::vector<cv::Point> pixels;
      for (int i = 0; i < 8; ++i) {
        const Eigen::Vector3d corner(1.0 * std::sin(2.0 * k) + (i & 1 ? 0.14 : -0.14),
                                     1.0 * std::cos(1.3 * k) + (i & 2 ? 0.05 : -0.05),
                                     i & 4 ? 1.8 : 0.0);
        const auto pixel = Camera(camera).project(corner);
        pixels.emplace_back(int(std::lround(pixel->x())), int(std::lround(pixel->y())));
      }
      std::vector<cv::Point> outline;
      cv::convexHull(pixels, outline);
      cv::fillConvexPoly(set.back(), outline, 255);
    }
    sets.push_back(set);
  }
  return sets;
}

TEST(Calibrate, FloorIsWhereAPersonTrod) {
  BoardScene scene;
  scene.addRing(5);
  CalibrationInput input = scene.input(30);
  input.walk = [&](const std::vector<double>& offsets) {
    EXPECT_EQ(offsets.size(), 5u);
    return planksThatStand(scene.cameras);
  };
  const RigCalibration result = calibrateRig(input);
  EXPECT_TRUE(result.floor_known);
  ASSERT_TRUE(result.walk);
  EXPECT_NEAR(result.walk->stature, 1.8, 0.05);
  EXPECT_EQ(result.verdict[1].substr(0, 38), "The floor is where the person trod: 14");
  for (size_t i = 0; i < 5; ++i) {
    const Eigen::Isometry3d& found = result.cameras[i].calibration.T_world_camera;
    const Eigen::Isometry3d& truth = scene.cameras[i].T_world_camera;
    EXPECT_NEAR(found.translation().z(), truth.translation().z(), 0.03) << i;
    // How far down it looks, and how it is rolled.
    EXPECT_NEAR(found.linear()(2, 2), truth.linear()(2, 2), 0.01) << i;
    EXPECT_NEAR(found.linear()(2, 0), truth.linear()(2, 0), 0.01) << i;
  }
}

TEST(Calibrate, KnownPointsPlaceCamerasThatShareNoView) {
  BoardScene scene;
  scene.addRing(3);
  CalibrationInput input = scene.input(25);
  for (BoardView& view : input.views) view.alone = true;
  for (int k = 0; k < 8; ++k) {
    KnownPoint point;
    point.name = std::to_string(k);
    point.position << (k & 1) * 1.0 - 0.5, (k & 2) * 0.5 - 0.5, (k & 4) * 0.2;
    for (size_t i = 0; i < 3; ++i)
      if (const auto pixel = Camera(scene.cameras[i]).projectInside(point.position))
        point.pixels.emplace_back(i, *pixel);
    input.points.push_back(point);
  }
  const RigCalibration result = calibrateRig(input);
  for (size_t i = 0; i < 3; ++i)
    EXPECT_LT((result.cameras[i].calibration.T_world_camera.translation() -
               scene.cameras[i].T_world_camera.translation())
                  .norm(),
              0.02);
  EXPECT_LT(result.points_rms, 1.0);
  EXPECT_TRUE(std::any_of(result.verdict.begin(), result.verdict.end(), [](const auto& sentence) {
    return sentence.find("The known points are met to 0.") == 0;
  }));
}

TEST(Calibrate, BoardThatLooksTheSameTurnedIsTurnedToAgree) {
  BoardScene scene;
  scene.board.kind = "chessboard";
  scene.board.columns = 9;
  scene.board.rows = 7;
  scene.board.square = 0.09;
  scene.addRing(4);
  CalibrationInput input = scene.input(25);
  std::mt19937 random(9);
  for (BoardView& view : input.views) {
    if (view.corners.ids.size() == Board(scene.board).corners().size() && random() % 2)
      std::reverse(view.corners.pixels.begin(), view.corners.pixels.end());
  }
  const RigCalibration result = calibrateRig(input);
  EXPECT_LT(rigError(result, scene.cameras).largestPosition(), 0.003);
}

TEST(Calibrate, WhatIsMissingIsTold) {
  BoardScene scene;
  scene.addRing(3);
  CalibrationInput input = scene.input(25);
  CalibrationInput few = input;
  few.views.erase(std::remove_if(few.views.begin(), few.views.end(),
                                 [](const BoardView& view) { return view.camera == 1; }),
                  few.views.end());
  EXPECT_EQ(errorTextOf([&] { calibrateRig(few); }),
            "the board was found in 0 pictures of cam1, its lens needs at least 5: is the board "
            "described rightly (squares are counted, not inner corners)?");
  CalibrationInput apart = input;
  for (BoardView& view : apart.views)
    if (view.camera == 2) view.time += 1000;
  EXPECT_EQ(
      errorTextOf([&] { calibrateRig(apart); }),
      "no picture joins cam2 to cam0, cam1: show the board where both see it at the same time");
  EXPECT_EQ(errorTextOf([&] { calibrateRig({}); }), "there is no camera to calibrate");
}

}  // namespace
}  // namespace markerless_mocap
