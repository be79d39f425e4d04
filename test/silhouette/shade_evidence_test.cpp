#include "silhouette/shade_evidence.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

/// Foreground left, right and below of a gap, as a shirt on trousers has it.
cv::Mat bodyWithGap() {
  cv::Mat mask = cv::Mat::zeros(200, 200, CV_8UC1);
  cv::rectangle(mask, {60, 40, 80, 120}, 255, cv::FILLED);
  cv::rectangle(mask, {85, 40, 30, 60}, 0, cv::FILLED);
  return mask;
}

/// Brightness ratio 0.8 with stripes of `contrast`, within `area`; 0 elsewhere.
cv::Mat shade(const cv::Rect& area, float contrast) {
  cv::Mat ratio = cv::Mat::zeros(200, 200, CV_32FC1);
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x)
      ratio.at<float>(y, x) = 0.8f + ((x / 3) % 2 ? contrast : -contrast);
  return ratio;
}

TEST(EnclosingSides, SeesAsFarAsItsReach) {
  cv::Mat mask = cv::Mat::zeros(1, 20, CV_8UC1);
  mask.at<uint8_t>(0, 5) = 255;
  const cv::Mat sides = enclosingSides(mask, 3);
  EXPECT_EQ(sides.at<uint8_t>(0, 8), kLeft);
  EXPECT_EQ(sides.at<uint8_t>(0, 9), 0);
  EXPECT_EQ(sides.at<uint8_t>(0, 2), kRight);
  EXPECT_EQ(sides.at<uint8_t>(0, 1), 0);
}

TEST(EnclosingSides, TellsAboveFromBelow) {
  const cv::Mat sides = enclosingSides(bodyWithGap(), 100);
  EXPECT_EQ(sides.at<uint8_t>(70, 100), kLeft | kRight | kBelow);
  EXPECT_EQ(sides.at<uint8_t>(180, 100), kAbove);
  EXPECT_EQ(sides.at<uint8_t>(10, 100), kBelow);
}

TEST(RestoreClothes, UnevenShadeWithinThePersonIsClothes) {
  cv::Mat mask = bodyWithGap();
  restoreClothes(shade({85, 40, 30, 60}, 0.06f), &mask);
  EXPECT_EQ(mask.at<uint8_t>(90, 100), 255);
}

TEST(RestoreClothes, EvenShadeWithinThePersonStaysShadow) {
  cv::Mat mask = bodyWithGap();
  restoreClothes(shade({85, 40, 30, 60}, 0.01f), &mask);
  EXPECT_EQ(cv::countNonZero(mask != bodyWithGap()), 0);
}

TEST(RestoreClothes, TheSameShadeOnTheFloorStaysShadow) {
  cv::Mat mask = bodyWithGap();
  restoreClothes(shade({60, 162, 80, 30}, 0.06f), &mask);
  EXPECT_EQ(cv::countNonZero(mask != bodyWithGap()), 0);
}

}  // namespace
}  // namespace markerless_mocap
