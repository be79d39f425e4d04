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

/// Pixels of a colour, and those that are nearly so, as lines are smooth.
int pixelsOf(const cv::Mat& view, const cv::Scalar& color) {
  cv::Mat found;
  cv::inRange(view, color - cv::Scalar::all(25), color + cv::Scalar::all(25), found);
  return cv::countNonZero(found);
}

// Of 80 x 60 pixels, the left quarter is unknown; the person is 10 x 20, the body 6 x 30.
TEST(Evidence, IsTheWholeViewWithTheUnknownTintedAndBothOutlines) {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1), body = mask.clone();
  mask(cv::Rect(0, 0, 20, 60)).setTo(128);
  mask(cv::Rect(40, 20, 10, 20)).setTo(255);
  body(cv::Rect(60, 20, 6, 30)).setTo(255);
  const cv::Mat view = evidenceOf(oneCamera()[0], {smallImage(false), cv::Mat()}, mask, body);
  ASSERT_EQ(view.size(), cv::Size(kEvidenceWidth, 345));
  ASSERT_EQ(view.type(), CV_8UC3);
  cv::Mat tinted;
  cv::inRange(view, cv::Scalar(140, 80, 0), cv::Scalar(255, 160, 79), tinted);
  EXPECT_NEAR(cv::countNonZero(tinted), 0.25 * view.total(), 0.01 * view.total());
  const double scale = kEvidenceWidth / 80.0;
  EXPECT_NEAR(pixelsOf(view, {40, 40, 230}), 2 * (10 + 20) * scale, 0.1 * 2 * (10 + 20) * scale);
  EXPECT_NEAR(pixelsOf(view, {60, 200, 60}), 2 * (6 + 30) * scale, 0.1 * 2 * (6 + 30) * scale);
  EXPECT_EQ(view.at<cv::Vec3b>(172, int(45 * scale)), cv::Vec3b(80, 80, 80)) << "inside the person";
}

TEST(Evidence, WithoutMaskAndBodyIsTheImage) {
  const cv::Mat view =
      evidenceOf(oneCamera()[0], {smallImage(true), cv::Mat()}, cv::Mat(), cv::Mat());
  ASSERT_EQ(view.size(), cv::Size(kEvidenceWidth, 345));
  EXPECT_EQ(view.at<cv::Vec3b>(5, 5), cv::Vec3b(80, 80, 80));
  EXPECT_EQ(view.at<cv::Vec3b>(172, 230), cv::Vec3b(30, 200, 240));
}

}  // namespace
}  // namespace markerless_mocap
