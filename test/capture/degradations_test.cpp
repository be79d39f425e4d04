#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

#include "capture/cameras/camera_rigs.h"
#include "capture/trouble_fixture.h"

namespace markerless_mocap {
namespace {

int pixels(const std::vector<cv::Mat>& masks) {
  int sum = 0;
  for (const cv::Mat& mask : masks) sum += cv::countNonZero(mask);
  return sum;
}

TEST(TroublesTest, noneLeavesTheEmptyRoomAsItIs) {
  const VirtualStudio room = studio(easyStudio());
  const StudioFrameSet empty = room.render(0), action = room.render(10);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_LT(meanDifference(empty.images[i], action.images[i], ~action.masks[i]), 0.3);
    EXPECT_EQ(cv::norm(action.silhouettes[i], action.masks[i], cv::NORM_INF), 0.0);
    EXPECT_EQ(room.rig()[i].calibration().T_world_camera.matrix(),
              room.trueRig()[i].calibration().T_world_camera.matrix());
  }
}

TEST(TroublesTest, noiseHasItsStrength) {
  const StudioFrameSet quiet = studio(easyStudio()).render(0);
  const StudioFrameSet noisy = studio(with(&DegradationOptions::noise_stddev, 4.0)).render(0);
  // The mean absolute value of a normal deviate is 0.80 of its standard deviation.
  EXPECT_NEAR(meanDifference(quiet.images[0], noisy.images[0], cv::Mat()), 3.2, 0.4);
}

TEST(TroublesTest, lightFlickersFromInstantToInstant) {
  StudioOptions options = with(&DegradationOptions::flicker, 0.05);
  options.background_frames = 12;
  const VirtualStudio room = studio(options);
  double lowest = 1e9, highest = 0.0;
  for (int i = 0; i < 12; ++i) {
    const double brightness = cv::mean(room.render(i).images[0])[1];
    lowest = std::min(lowest, brightness);
    highest = std::max(highest, brightness);
  }
  EXPECT_GT(highest / lowest, 1.03);
  EXPECT_LT(highest / lowest, 1.5);
}

TEST(TroublesTest, shadowDarkensTheRoom) {
  const StudioFrameSet bright = studio(easyStudio()).render(10);
  const StudioFrameSet dark = studio(with(&DegradationOptions::shadow_strength, 1.0)).render(10);
  for (size_t i = 0; i < 4; ++i)
    EXPECT_LT(cv::mean(dark.images[i], ~dark.masks[i])[1],
              cv::mean(bright.images[i], ~bright.masks[i])[1] - 0.3);
}

TEST(TroublesTest, camouflageBringsThePersonNearTheRoom) {
  const auto contrast = [](const StudioOptions& options) {
    const VirtualStudio room = studio(options);
    const StudioFrameSet empty = room.render(0), action = room.render(10);
    double sum = 0.0;
    for (size_t i = 0; i < 4; ++i)
      sum += meanDifference(empty.images[i], action.images[i], action.masks[i]);
    return sum;
  };
  EXPECT_LT(contrast(with(&DegradationOptions::camouflage, 0.9)), 0.75 * contrast(easyStudio()));
}

TEST(TroublesTest, maskDamageSpoilsTheSilhouettesOnly) {
  const StudioFrameSet whole = studio(easyStudio()).render(10);
  const StudioFrameSet spoilt = studio(with(&DegradationOptions::mask_damage, 0.6)).render(10);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(cv::norm(whole.masks[i], spoilt.masks[i], cv::NORM_INF), 0.0);
    EXPECT_EQ(cv::norm(whole.images[i], spoilt.images[i], cv::NORM_INF), 0.0);
    EXPECT_GT(cv::countNonZero(spoilt.silhouettes[i] != spoilt.masks[i]), 20);
  }
}

TEST(TroublesTest, calibrationErrorIsThatManyPixels) {
  StudioOptions options = with(&DegradationOptions::calibration_error_px, 3.0);
  options.rig = "random8";
  const VirtualStudio room = studio(options);
  for (size_t i = 0; i < 8; ++i)
    for (const Eigen::Vector3d& point : {Eigen::Vector3d(0, 0, 1), Eigen::Vector3d(0.6, -0.5, 1.6)})
      EXPECT_NEAR((*room.rig()[i].project(point) - *room.trueRig()[i].project(point)).norm(), 3.0,
                  0.8);
}

TEST(TroublesTest, camerasOutOfStepSeeOtherTimes) {
  StudioOptions options = with(&DegradationOptions::time_offset_ms, 200.0);
  options.motion = "walk";
  StudioOptions in_step = easyStudio();
  in_step.motion = "walk";
  const StudioFrameSet a = studio(in_step).render(30), b = studio(options).render(30);
  int different = 0;
  for (size_t i = 0; i < 4; ++i) different += cv::countNonZero(a.masks[i] != b.masks[i]) > 20;
  EXPECT_GE(different, 3);
  EXPECT_EQ(a.points, b.points);
  EXPECT_EQ(a.time_ns, b.time_ns);
}

TEST(TroublesTest, imagesDropAtTheirRate) {
  StudioOptions options = with(&DegradationOptions::drop_rate, 0.3);
  options.width = 32;
  options.height = 24;
  options.background_frames = 100;
  const VirtualStudio room = studio(options);
  int dropped = 0;
  for (int i = 0; i < 100; ++i)
    for (const cv::Mat& image : room.render(i).images) dropped += image.empty();
  EXPECT_NEAR(dropped, 120, 35);
}

TEST(TroublesTest, exposureBlursWhatMoves) {
  StudioOptions sharp = easyStudio(), blurred = with(&DegradationOptions::exposure_ms, 60.0);
  for (StudioOptions* options : {&sharp, &blurred}) options->motion = "walk";
  const StudioFrameSet a = studio(sharp).render(50), b = studio(blurred).render(50);
  EXPECT_EQ(a.points, b.points);
  double changed = 0.0;
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(cv::norm(a.masks[i], b.masks[i], cv::NORM_INF), 0.0);
    changed += meanDifference(a.images[i], b.images[i], cv::Mat());
  }
  EXPECT_GT(changed, 0.1);
}

TEST(TroublesTest, secondPersonIsSeenButIsNotTheTruth) {
  const StudioFrameSet one = studio(easyStudio()).render(10);
  const StudioFrameSet two =
      studio(with(&DegradationOptions::second_person_distance, 1.2)).render(10);
  EXPECT_GT(pixels(two.masks), 1.5 * pixels(one.masks));
  EXPECT_EQ(one.points, two.points);
}

TEST(TroublesTest, chairHidesAndIsThereFromTheBeginning) {
  const StudioOptions options = with(&DegradationOptions::chair_distance, 0.15);
  const StudioFrameSet plain = studio(easyStudio()).render(0), empty = studio(options).render(0);
  double changed = 0.0;
  for (size_t i = 0; i < 4; ++i)
    changed += meanDifference(plain.images[i], empty.images[i], cv::Mat());
  EXPECT_GT(changed, 0.3);
  EXPECT_EQ(pixels(empty.masks), 0);
  EXPECT_LT(pixels(studio(options).render(10).masks),
            pixels(studio(easyStudio()).render(10).masks));
}

}  // namespace
}  // namespace markerless_mocap
