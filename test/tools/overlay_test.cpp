#include "tools/common/overlay.h"

#include <gtest/gtest.h>

#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

CameraRig oneCamera() {
  return {Camera(ringOfFour()[0])};
}

int greenPixels(const cv::Mat& sheet) {
  int count = 0;
  for (int y = 0; y < sheet.rows; ++y)
    for (int x = 0; x < sheet.cols; ++x) {
      const auto pixel = sheet.at<cv::Vec3b>(y, x);
      count += pixel[1] > pixel[0] + 40 && pixel[1] > pixel[2] + 40;
    }
  return count;
}

TEST(Overlay, ShowsThePartThatBodyAndMaskCover) {
  // A body of 4 x 6 of 80 x 60 pixels: shown with some room around it, it fills about half of the
  // tile.
  cv::Mat body = cv::Mat::zeros(60, 80, CV_8UC1);
  body(cv::Rect(70, 50, 4, 6)).setTo(255);
  const cv::Mat sheet = overlayOf(oneCamera(), {{smallImage(false), cv::Mat()}}, {body}, {body});
  ASSERT_EQ(sheet.cols, 320);
  EXPECT_GT(greenPixels(sheet), 320 * 240 / 4);
}

TEST(Overlay, WithoutBodyAndMaskIsTheWholeImage) {
  const cv::Mat sheet = overlayOf(oneCamera(), {{smallImage(true), cv::Mat()}}, {cv::Mat()}, {});
  ASSERT_EQ(sheet.size(), cv::Size(320, 240));
  EXPECT_EQ(sheet.at<cv::Vec3b>(120, 160), cv::Vec3b(30, 200, 240));  // the box in the middle
  EXPECT_EQ(sheet.at<cv::Vec3b>(230, 5), cv::Vec3b(80, 80, 80));
}

// The person fills 10 x 20 of 33 x 25 pixels that are shown; the outline covers some of them.
TEST(Overlay, WhatIsUnknownIsNotShownAsThePerson) {
  cv::Mat mask(60, 80, CV_8UC1, cv::Scalar(128));
  mask(cv::Rect(30, 10, 20, 30)).setTo(0);
  mask(cv::Rect(35, 15, 10, 20)).setTo(255);
  const cv::Mat sheet = overlayOf(oneCamera(), {{cv::Mat(), mask}}, {mask}, {});
  int unknown = 0, person = 0;
  for (int y = 0; y < sheet.rows; ++y)
    for (int x = 0; x < sheet.cols; ++x) {
      const auto pixel = sheet.at<cv::Vec3b>(y, x);
      unknown += pixel[0] > pixel[2] + 40;
      person += pixel == cv::Vec3b(120, 120, 120);
    }
  const double tile = sheet.rows * sheet.cols;
  EXPECT_NEAR(person / tile, 200.0 / (33 * 25), 0.03);
  EXPECT_GT(unknown, sheet.rows);  // its outline, in a colour of its own
  EXPECT_LT(unknown / tile, 0.05);
}

TEST(Overlay, ABodyAtTheEdgeStaysInTheImage) {
  cv::Mat body = cv::Mat::zeros(60, 80, CV_8UC1);
  body.col(79).setTo(255);  // as high as the image
  EXPECT_EQ(overlayOf(oneCamera(), {{smallImage(false), body}}, {body}, {body}).size(),
            cv::Size(320, 240));
}

}  // namespace
}  // namespace markerless_mocap
