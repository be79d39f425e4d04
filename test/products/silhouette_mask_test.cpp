#include "markerless_mocap/products/silhouette_mask.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <opencv2/core.hpp>

namespace markerless_mocap {
namespace {

cv::Mat row(std::initializer_list<int> values) {
  cv::Mat mask(1, int(values.size()), CV_8UC1);
  std::copy(values.begin(), values.end(), mask.begin<uchar>());
  return mask;
}

bool areEqual(const cv::Mat& a, const cv::Mat& b) {
  return a.type() == b.type() && a.size() == b.size() && cv::norm(a, b, cv::NORM_INF) == 0.0;
}

TEST(SilhouetteMask, OtherValuesThanUnknownAreThePerson) {
  EXPECT_TRUE(areEqual(maskOfThreeValues(row({0, 1, 127, 128, 129, 255})),
                       row({0, 255, 255, 128, 255, 255})));
  EXPECT_TRUE(areEqual(maskOfThreeValues(row({0, 7, 200})), row({0, 255, 255})));
}

TEST(SilhouetteMask, ThreeValuesAreACopy) {
  const cv::Mat grey = row({0, 255});
  EXPECT_NE(maskOfThreeValues(grey).data, grey.data);
}

TEST(SilhouetteMask, UnknownPixelsAreNotThePersons) {
  EXPECT_TRUE(areEqual(personPixels(row({0, 1, 128, 255})), row({0, 255, 0, 255})));
}

TEST(SilhouetteMask, UnknownPixelsAreFoundInTheLastRowOfAPart) {
  cv::Mat mask(20, 30, CV_8UC1, cv::Scalar(0));
  EXPECT_FALSE(hasUnknownPixels(mask));
  mask.at<uchar>(12, 9) = 128;
  EXPECT_TRUE(hasUnknownPixels(mask(cv::Rect(5, 5, 5, 8))));
  EXPECT_FALSE(hasUnknownPixels(mask(cv::Rect(5, 5, 4, 8))));
  EXPECT_FALSE(hasUnknownPixels(cv::Mat()));
}

TEST(SilhouetteMask, AFewUnknownPixelsAreNoUnknownBackground) {
  cv::Mat mask(100, 100, CV_8UC1, cv::Scalar(255));
  mask.colRange(0, 50).setTo(0);
  mask(cv::Rect(20, 20, 5, 1)).setTo(128);
  EXPECT_FALSE(hasUnknownBackground(mask));
  mask(cv::Rect(20, 20, 6, 1)).setTo(128);
  EXPECT_TRUE(hasUnknownBackground(mask));
  EXPECT_FALSE(hasUnknownBackground(cv::Mat()));
}

}  // namespace
}  // namespace markerless_mocap
