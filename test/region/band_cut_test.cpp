#include "region/cut/band_cut.h"

#include <gtest/gtest.h>

#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

/// Dark left of the column 20, bright right of it.
cv::Mat stepImage() {
  cv::Mat image(30, 40, CV_8UC3, cv::Scalar(200, 200, 200));
  image.colRange(0, 20).setTo(cv::Scalar(40, 40, 40));
  return image;
}

TEST(BandCut, PutsTheBorderAtTheEdgeOfTheImage) {
  // Known up to the columns 12 and 28; between them nothing speaks for either side.
  cv::Mat log_odds(30, 40, CV_32FC1, cv::Scalar(0)), band(30, 40, CV_8UC1, cv::Scalar(0));
  log_odds.colRange(0, 12).setTo(10);
  log_odds.colRange(28, 40).setTo(-10);
  band.colRange(12, 28).setTo(255);
  const cv::Mat mask = bandCut(stepImage(), log_odds, band);
  EXPECT_EQ(cv::countNonZero(mask.colRange(0, 20)), 30 * 20);
  EXPECT_EQ(cv::countNonZero(mask.colRange(20, 40)), 0);
}

TEST(BandCut, OutvotesSingleSamples) {
  cv::Mat log_odds(30, 40, CV_32FC1, cv::Scalar(-1)), band(30, 40, CV_8UC1, cv::Scalar(255));
  log_odds.colRange(0, 20).setTo(1);
  log_odds.at<float>(15, 5) = -2;
  log_odds.at<float>(15, 35) = 2;
  const cv::Mat mask = bandCut(stepImage(), log_odds, band);
  EXPECT_EQ(mask.at<uchar>(15, 5), 255);
  EXPECT_EQ(mask.at<uchar>(15, 35), 0);
}

TEST(BandCut, LeavesDecidedSamplesAlone) {
  cv::Mat log_odds(30, 40, CV_32FC1, cv::Scalar(-1)), band(30, 40, CV_8UC1, cv::Scalar(0));
  log_odds.at<float>(15, 35) = 0.5f;
  const cv::Mat mask = bandCut(stepImage(), log_odds, band);
  EXPECT_EQ(cv::countNonZero(mask), 1);
  EXPECT_EQ(mask.at<uchar>(15, 35), 255);
}

}  // namespace
}  // namespace markerless_mocap
