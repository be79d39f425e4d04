#include <gtest/gtest.h>

#include "pages/page_reader.h"
#include "tools/common/player_views.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

CameraRig oneCamera() {
  return {Camera(ringOfFour()[0])};
}

// Of 80 x 60 pixels, the left quarter is unknown; the person is 10 x 20, the body 6 x 30.
TEST(PlayerViews, HaveTheImageAndTheOutlinesOfBodyMaskAndUnknown) {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1), body = mask.clone();
  mask(cv::Rect(0, 0, 20, 60)).setTo(128);
  mask(cv::Rect(40, 20, 10, 20)).setTo(255);
  body(cv::Rect(60, 10, 6, 30)).setTo(255);
  PlayerViews views;
  views.add(3, oneCamera(), {{smallImage(false), cv::Mat()}}, {mask}, {body});
  const Json json = views.json();
  ASSERT_EQ(json.size(), 1u);
  EXPECT_EQ(json[0]["frame"], 3);
  const Json view = json[0]["cameras"][0];
  EXPECT_NEAR(view["aspect"], 0.75, 0.02) << "whole pixels";
  EXPECT_EQ(view["jpeg"].get<std::string>().substr(0, 4), "/9j/");
  const auto outline = unpacked<int16_t>(view["mask"]), around = unpacked<int16_t>(view["body"]);
  ASSERT_EQ(outline.size(), 9u);
  EXPECT_EQ(outline[0], 4) << "corners";
  // The body's 6 x 30 pixels in the ratio 4 : 3 with a margin are 50 x 37.5, which is 5/8 of the
  // image: the person's width is a fifth of it.
  const auto [left, right] = std::minmax({outline[1], outline[3], outline[5], outline[7]});
  const auto [b_left, b_right] = std::minmax({around[1], around[3], around[5], around[7]});
  EXPECT_NEAR(right - left, 2048 * 9 / 50, 2);
  EXPECT_NEAR(b_right - left, 2048 * 25 / 50, 2) << "the body lies to the right of the mask";
  EXPECT_GT(b_left, right);
}

TEST(PlayerViews, WithoutImagesHaveOutlinesOnly) {
  cv::Mat mask = cv::Mat::zeros(60, 80, CV_8UC1);
  mask(cv::Rect(40, 20, 10, 20)).setTo(255);
  PlayerViews views(false);
  views.add(0, oneCamera(), {{smallImage(false), cv::Mat()}}, {mask}, {});
  const Json view = views.json()[0]["cameras"][0];
  EXPECT_EQ(view["jpeg"], "");
  EXPECT_EQ(view["body"], "");
  EXPECT_NE(view["mask"], "");
}

}  // namespace
}  // namespace markerless_mocap
