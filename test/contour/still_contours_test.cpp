#include "contour/track/still_contours.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 80'000'000;
constexpr int kFrames = 24;
const cv::Rect kBoard(20, 60, 40, 140);  ///< stands beside the person, pixels

class StillContoursTest : public testing::Test {
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
      contours.compare(seen, body, pose);
    }
  }
  static bool onBoard(const ContourRay& ray) { return ray.pixel.x() < float(kBoard.br().x + 1); }

  CameraRig rig = drawnRig(3);
  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  ContourObserver observer{rig, ContourOptions()};
  StillContours contours{rig};
  ContourPose pose;
  std::vector<cv::Mat> masks;
  ContourObservation seen;
};

TEST_F(StillContoursTest, WhatStandsStillBesideALivingPersonCountsLess) {
  film(0.03);
  EXPECT_TRUE(contours.showLife(seen));
  contours.weigh(seen);
  int board = 0, board_reduced = 0, person = 0, person_reduced = 0;
  for (const ContourRay& ray : seen.rays) {
    ++(onBoard(ray) ? board : person);
    if (ray.weight < 1.0f) ++(onBoard(ray) ? board_reduced : person_reduced);
  }
  ASSERT_GT(board, 100);
  EXPECT_EQ(board_reduced, board);
  EXPECT_LT(person_reduced, 0.15 * person) << "contours along which the person sways";
}

TEST_F(StillContoursTest, WhereNothingMovesThereIsNoLife) {
  film(0.0);
  EXPECT_FALSE(contours.showLife(seen));
}

// A camera's images are read while its background is unknown, and its masks afterwards.
TEST_F(StillContoursTest, LifeIsSeenWhenMasksFollowImages) {
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

TEST_F(StillContoursTest, ABodyThatRestsKeepsItsWeightIfItExplainsTheContours) {
  for (int i = 0; i < kFrames; ++i) {
    pose = stride();
    masks = drawnMasks(rig, body, pose);
    contours.watch((i + 1) * kFrame_ns, {}, masks);
    seen = observer.observe(masks);
    contours.compare(seen, body, pose);
  }
  contours.weigh(seen);
  for (const ContourRay& ray : seen.rays) EXPECT_EQ(ray.weight, 1.0f);
}

TEST_F(StillContoursTest, ResetForgets) {
  film(0.03);
  contours.reset();
  EXPECT_FALSE(contours.showLife(seen));
  contours.weigh(seen);
  for (const ContourRay& ray : seen.rays) EXPECT_EQ(ray.weight, 1.0f);
}

}  // namespace
}  // namespace markerless_mocap
