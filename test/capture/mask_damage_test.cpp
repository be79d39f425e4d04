#include "capture/degradations/mask_damage.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>
#include <stdexcept>

namespace markerless_mocap {
namespace {

/// A standing person's size: 12000 pixels of 640 x 480.
cv::Mat figure() {
  cv::Mat mask = cv::Mat::zeros(480, 640, CV_8UC1);
  cv::rectangle(mask, {300, 150}, {345, 420}, cv::Scalar(255), cv::FILLED);
  return mask;
}

double lostShare(double amount) {
  const cv::Mat mask = figure();
  double lost = 0.0;
  for (uint64_t stream = 0; stream < 20; ++stream)
    lost += cv::countNonZero(mask & ~damagedMask(mask, amount, stream));
  return lost / 20.0 / cv::countNonZero(mask);
}

TEST(MaskDamageTest, noneIsACopy) {
  const cv::Mat mask = figure(), copy = damagedMask(mask, 0.0, 3);
  EXPECT_EQ(cv::norm(mask, copy, cv::NORM_INF), 0.0);
  EXPECT_NE(mask.data, copy.data);
}

TEST(MaskDamageTest, moreLosesMore) {
  EXPECT_GT(lostShare(0.2), 0.005);
  EXPECT_NEAR(lostShare(0.5), 0.05, 0.02);
  EXPECT_GT(lostShare(1.0), lostShare(0.5) + 0.02);
  EXPECT_LT(lostShare(1.0), 0.4);
}

TEST(MaskDamageTest, specksHolesAndARaggedEdgeAppear) {
  const cv::Mat mask = figure(), damaged = damagedMask(mask, 0.6, 7);
  cv::Mat inside, near;
  cv::erode(mask, inside, cv::Mat(), {-1, -1}, 8);
  cv::dilate(mask, near, cv::Mat(), {-1, -1}, 8);
  EXPECT_GT(cv::countNonZero(inside & ~damaged), 20);
  EXPECT_GT(cv::countNonZero(damaged & ~near), 20);
  EXPECT_GT(cv::countNonZero(damaged & near & ~mask), 20);
  EXPECT_EQ(cv::countNonZero((damaged != 0) & (damaged != 255)), 0);
}

TEST(MaskDamageTest, dependsOnTheStreamAlone) {
  const cv::Mat mask = figure();
  EXPECT_EQ(cv::norm(damagedMask(mask, 0.5, 1), damagedMask(mask, 0.5, 1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(damagedMask(mask, 0.5, 1), damagedMask(mask, 0.5, 2), cv::NORM_INF), 0.0);
}

TEST(MaskDamageTest, emptyMaskGetsSpecksOnly) {
  const cv::Mat damaged = damagedMask(cv::Mat::zeros(480, 640, CV_8UC1), 1.0, 1);
  EXPECT_GT(cv::countNonZero(damaged), 50);
  EXPECT_LT(cv::countNonZero(damaged), 5000);
}

TEST(MaskDamageTest, amountBeyondOneIsRefused) {
  EXPECT_THROW(damagedMask(figure(), 1.1, 1), std::invalid_argument);
  EXPECT_THROW(damagedMask(figure(), -0.1, 1), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
