#include "contour/track/moving_contours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 80'000'000;
constexpr int kFrames = 24;
const cv::Rect kBoard(20, 60, 40, 140);  ///< stands beside the person, pixels

class MovingContoursTest : public testing::Test {
 protected:
  /// One who sways by centimetres, beside a board in every view.
  void film(double sway) {
    for (int i = 0; i < kFrames; ++i) {
      pose = stride();
      pose.position.y() += sway * std::sin(0.4 * i);
      masks = drawnMasks(rig, body, pose);
      for (cv::Mat& mask : masks) mask(kBoard) = 255;
      contours.watch((i + 1) * kFrame_ns, {}, masks);
      seen = observer.observe(masks);
    }
  }

  CameraRig rig = drawnRig(3);
  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  ContourObserver observer{rig, ContourOptions()};
  MovingContours contours{rig.size()};
  ContourPose pose;
  std::vector<cv::Mat> masks;
  ContourObservation seen;
};

TEST_F(MovingContoursTest, OneWhoSwaysShowsLifeBesideABoard) {
  film(0.03);
  EXPECT_TRUE(contours.showLife(seen));
}

TEST_F(MovingContoursTest, WhereNothingMovesThereIsNoLife) {
  film(0.0);
  EXPECT_FALSE(contours.showLife(seen));
}

// A camera's images are read while its background is unknown, and its masks afterwards.
TEST_F(MovingContoursTest, LifeIsSeenWhenMasksFollowImages) {
  const auto at = [&](int i) {
    pose = stride();
    pose.position.y() += 0.03 * std::sin(0.4 * i);
    masks = drawnMasks(rig, body, pose);
    std::vector<cv::Mat> images;
    for (const cv::Mat& mask : masks) images.push_back(90 + mask / 4);
    return images;
  };
  for (int i = 0; i < kFrames; ++i) contours.watch((i + 1) * kFrame_ns, at(i), masks);
  for (int i = kFrames; i < kFrames + 5; ++i) {
    at(i);
    contours.watch((i + 1) * kFrame_ns, {}, masks);
  }
  EXPECT_TRUE(contours.showLife(observer.observe(masks)));
}

TEST_F(MovingContoursTest, TheContoursOfTheBoardAloneShowNone) {
  film(0.03);
  const auto beside = [](const ContourRay& ray) { return ray.pixel.x() > float(kBoard.br().x); };
  seen.rays.erase(std::remove_if(seen.rays.begin(), seen.rays.end(), beside), seen.rays.end());
  ASSERT_GT(seen.rays.size(), 100u);
  EXPECT_FALSE(contours.showLife(seen));
}

TEST_F(MovingContoursTest, ResetForgets) {
  film(0.03);
  contours.reset();
  EXPECT_FALSE(contours.showLife(seen));
}

}  // namespace
}  // namespace markerless_mocap
