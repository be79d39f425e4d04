#include "capture/degradations/auto_camera.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

const cv::Scalar kUsual(120, 130, 140);

cv::Mat plain(const cv::Scalar& color) {
  return cv::Mat(60, 80, CV_8UC3, color);
}

cv::Scalar followed(const cv::Scalar& color, double exposure, double white_balance) {
  cv::Mat image = plain(color);
  followLight(exposure, white_balance, kUsual, image);
  return cv::mean(image);
}

void expectColor(const cv::Scalar& color, const cv::Scalar& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(color[i], expected[i], 1e-6);
}

double brightness(const cv::Scalar& color) {
  return (color[0] + color[1] + color[2]) / 3.0;
}

TEST(AutoCameraTest, nothingChangesWhenOffOrAsUsual) {
  cv::Mat image = plain({13, 77, 200});
  followLight(0.0, 0.0, kUsual, image);
  EXPECT_EQ(cv::norm(image, plain({13, 77, 200}), cv::NORM_INF), 0.0);
  expectColor(followed(kUsual, 1.0, 1.0), kUsual);
}

TEST(AutoCameraTest, exposureHoldsTheBrightnessAndKeepsTheHue) {
  const cv::Scalar dark(60, 65, 70);
  expectColor(followed(dark, 1.0, 0.0), kUsual);
  EXPECT_NEAR(followed(dark, 0.5, 0.0)[1], 65.0 * std::sqrt(2.0), 0.6);
  const cv::Scalar red = followed({50, 50, 100}, 1.0, 0.0);
  EXPECT_NEAR(brightness(red), brightness(kUsual), 0.6);
  EXPECT_NEAR(red[2] / red[0], 2.0, 0.02);
}

TEST(AutoCameraTest, whiteBalanceHoldsTheHueAndKeepsTheBrightness) {
  const cv::Scalar red(100, 130, 160);
  const cv::Scalar balanced = followed(red, 0.0, 1.0);
  EXPECT_NEAR(brightness(balanced), brightness(red), 0.6);
  EXPECT_NEAR(balanced[2] / balanced[0], kUsual[2] / kUsual[0], 0.01);
  const cv::Scalar half = followed(red, 0.0, 0.5);
  EXPECT_GT(half[2], balanced[2]);
  EXPECT_LT(half[2], red[2]);
}

TEST(AutoCameraTest, middleCountsMoreThanTheBorder) {
  cv::Mat in_middle = plain({100, 100, 100}), at_border = in_middle.clone();
  in_middle(cv::Rect(30, 20, 20, 20)).setTo(cv::Scalar::all(0));
  at_border(cv::Rect(0, 0, 20, 20)).setTo(cv::Scalar::all(0));
  EXPECT_LT(meteredColor(in_middle)[1], meteredColor(at_border)[1] - 10.0);
  EXPECT_NEAR(meteredColor(plain({1, 2, 3}))[2], 3.0, 1e-9);
}

TEST(AutoCameraTest, brightPartsBurnOut) {
  cv::Mat image = plain({20, 20, 20});
  image.row(0).setTo(cv::Scalar::all(200));
  followLight(1.0, 0.0, kUsual, image);
  EXPECT_EQ(image.at<cv::Vec3b>(0, 5), cv::Vec3b(255, 255, 255));
}

}  // namespace
}  // namespace markerless_mocap
