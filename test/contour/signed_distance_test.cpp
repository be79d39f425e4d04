#include "contour/fit/signed_distance.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

/// Number of pixels that differ from two distance transforms of OpenCV.
int differentPixels(const cv::Mat& shape) {
  cv::Mat inside, outside;
  cv::distanceTransform(shape, inside, cv::DIST_L2, cv::DIST_MASK_5, CV_32F);
  cv::distanceTransform(shape == 0, outside, cv::DIST_L2, cv::DIST_MASK_5, CV_32F);
  const cv::Mat distance = signedDistance(shape);
  int different = 0;
  for (int y = 0; y < shape.rows; ++y)
    for (int x = 0; x < shape.cols; ++x) {
      const float in = inside.at<float>(y, x), out = outside.at<float>(y, x);
      different += distance.at<float>(y, x) != (in > 0 ? 0.5f - in : out - 0.5f);
    }
  return different;
}

TEST(SignedDistance, IsThatOfOpenCvForDisksAndBars) {
  cv::Mat shape = cv::Mat::zeros(187, 131, CV_8UC1);
  cv::circle(shape, {60, 40}, 23, 255, cv::FILLED);
  cv::line(shape, {20, 60}, {110, 170}, 255, 9);
  EXPECT_EQ(differentPixels(shape), 0);
  EXPECT_EQ(differentPixels(~shape), 0);
}

TEST(SignedDistance, IsThatOfOpenCvForAnySpecks) {
  cv::RNG random(7);
  for (const cv::Size size : {cv::Size(1, 50), cv::Size(50, 1), cv::Size(3, 2), cv::Size(97, 64)})
    for (const double limit : {5.0, 128.0, 250.0}) {
      cv::Mat noise(size, CV_8UC1);
      random.fill(noise, cv::RNG::UNIFORM, 0, 256);
      EXPECT_EQ(differentPixels(noise < limit), 0) << size << " " << limit;
    }
}

TEST(SignedDistance, OfOneCornerReachesTheFarOne) {
  for (const cv::Point corner : {cv::Point(0, 0), cv::Point(299, 0), cv::Point(0, 399)}) {
    cv::Mat shape = cv::Mat::zeros(400, 300, CV_8UC1);
    shape.at<uchar>(corner) = 255;
    EXPECT_EQ(differentPixels(shape), 0) << corner;
  }
}

TEST(SignedDistance, OfAShapeWithoutABorderIsThatOfOpenCv) {
  EXPECT_EQ(differentPixels(cv::Mat::zeros(20, 30, CV_8UC1)), 0);
  EXPECT_EQ(differentPixels(cv::Mat(20, 30, CV_8UC1, cv::Scalar(255))), 0);
}

}  // namespace
}  // namespace markerless_mocap
