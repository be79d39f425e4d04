#include "capture/degradations/sensor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

cv::Mat noisy(double levels, double gain, uint64_t stream, int value = 120) {
  cv::Mat image(480, 640, CV_8UC3, cv::Scalar::all(value));
  applySensor(levels, gain, stream, image);
  return image;
}

cv::Mat centered(const cv::Mat& image) {
  cv::Mat values;
  image.reshape(1).convertTo(values, CV_32F);
  return values - cv::mean(values)[0];
}

TEST(SensorTest, noiseHasTheMeanAndSpreadAskedFor) {
  for (const double levels : {1.0, 3.0, 8.0}) {
    cv::Scalar mean, deviation;
    cv::meanStdDev(noisy(levels, 1.0, 5).reshape(1), mean, deviation);
    EXPECT_NEAR(mean[0], 120.0, 0.03);
    // Rounding to whole levels adds the variance of a uniform number.
    EXPECT_NEAR(deviation[0], std::sqrt(levels * levels + 1.0 / 12.0), 0.01 * levels);
  }
}

TEST(SensorTest, noiseHasTheTailsOfANormal) {
  const cv::Mat values = centered(noisy(8.0, 1.0, 5));
  const double beyond = cv::countNonZero(cv::abs(values) > 15.5);  // rounded: 16 levels and more
  EXPECT_NEAR(beyond / double(values.total()), std::erfc(15.5 / 8.0 / std::sqrt(2.0)), 0.003);
}

TEST(SensorTest, noiseOfNeighboursRowsAndStreamsIsUnrelated) {
  const cv::Mat one = centered(noisy(3.0, 1.0, 5)), other = centered(noisy(3.0, 1.0, 6));
  const auto correlation = [](const cv::Mat& a, const cv::Mat& b) {
    return a.dot(b) / std::sqrt(a.dot(a) * b.dot(b));
  };
  EXPECT_NEAR(correlation(one, other), 0.0, 0.01);
  EXPECT_NEAR(correlation(one.rowRange(0, 479), one.rowRange(1, 480)), 0.0, 0.01);
  for (const int shift : {1, 2, 3, 4})
    EXPECT_NEAR(
        correlation(one.colRange(shift, 1920).clone(), one.colRange(0, 1920 - shift).clone()), 0.0,
        0.01);
}

TEST(SensorTest, sameStreamGivesTheSameBytes) {
  EXPECT_EQ(cv::norm(noisy(3.0, 1.0, 9), noisy(3.0, 1.0, 9), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(noisy(3.0, 1.0, 9), noisy(3.0, 1.0, 10), cv::NORM_INF), 0.0);
}

TEST(SensorTest, gainScalesAndLevelsStayInRange) {
  EXPECT_EQ(noisy(0.0, 1.1, 1).at<cv::Vec3b>(3, 3), cv::Vec3b(132, 132, 132));
  EXPECT_EQ(noisy(0.0, 1.0, 1).at<cv::Vec3b>(3, 3), cv::Vec3b(120, 120, 120));
  EXPECT_EQ(noisy(0.0, 3.0, 1).at<cv::Vec3b>(3, 3), cv::Vec3b(255, 255, 255));
  const cv::Mat dark = noisy(5.0, 1.0, 1, 0);
  EXPECT_NEAR(double(cv::countNonZero(dark.reshape(1) > 60)), 0.0, 0.0);
}

TEST(FlickerTest, gainHasTheSpreadAskedForAndIsRepeatable) {
  double sum = 0.0, squares = 0.0;
  const int frames = 6000;
  for (int i = 0; i < frames; ++i) {
    const double off = flickerGain(0.01, i / 30.0, 4) - 1.0;
    sum += off;
    squares += off * off;
  }
  EXPECT_NEAR(sum / frames, 0.0, 5e-4);
  EXPECT_NEAR(std::sqrt(squares / frames), 0.01, 5e-4);
  EXPECT_EQ(flickerGain(0.01, 1.5, 4), flickerGain(0.01, 1.5, 4));
  EXPECT_NE(flickerGain(0.01, 1.5, 4), flickerGain(0.01, 1.5, 5));
  EXPECT_EQ(flickerGain(0.0, 1.5, 4), 1.0);
}

}  // namespace
}  // namespace markerless_mocap
