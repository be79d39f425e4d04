#include "silhouette/shade_evidence.h"

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

const cv::Size kSize(200, 200);
constexpr int kSide = ShadeBlocks::kSide;

/// Foreground left, right and below of a gap, as a shirt on trousers has it.
BitMask bodyWithGap() {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  cv::rectangle(mask, {60, 40, 80, 120}, 255, cv::FILLED);
  cv::rectangle(mask, {85, 40, 30, 60}, 0, cv::FILLED);
  return BitMask::fromMat(mask);
}

/// What becomes of the body when `area` has a brightness ratio of 0.8 with stripes of `contrast`.
BitMask restored(const cv::Rect& area, float contrast) {
  BitMask shade(kSize), mask = bodyWithGap();
  ShadeBlocks blocks;
  blocks.resize(kSize);
  for (int y = area.y; y < area.y + area.height; ++y)
    for (int x = area.x; x < area.x + area.width; ++x) {
      shade.set(x, y);
      blocks.add(x, y, uint8_t(255 * (0.8f + ((x / 3) % 2 ? contrast : -contrast))));
    }
  restoreClothes(shade, blocks, &mask);
  return mask;
}

TEST(ShadeBlocks, VarianceIsOverNineBlocks) {
  ShadeBlocks blocks;
  blocks.resize({20, 20});
  blocks.add(8, 8, 255);
  blocks.add(7, 7, 153);  // 0.6, in the block up and left
  EXPECT_NEAR(blocks.variance(2, 2), 0.2 * 0.2, 1e-4);
  EXPECT_NEAR(blocks.variance(1, 1), 0.2 * 0.2, 1e-4);
  EXPECT_EQ(blocks.variance(3, 3), 0);
  EXPECT_TRUE(blocks.isEmpty(3, 3));
}

TEST(EnclosedBlocks, NeedForegroundBelowAndOnOneMoreSide) {
  const BitMask enclosed = enclosedBlocks(bodyWithGap(), 100);
  EXPECT_TRUE(enclosed.at(100 / kSide, 70 / kSide));
  EXPECT_FALSE(enclosed.at(100 / kSide, 180 / kSide)) << "only above it";
  EXPECT_FALSE(enclosed.at(100 / kSide, 10 / kSide)) << "only below it";
}

TEST(EnclosedBlocks, SeeAsFarAsTheirReach) {
  BitMask mask(cv::Size(1200, 400));  // blocks of several words
  mask.fill(399, 0, 1199, true);
  mask.fill(200, 400, 403, true);
  const BitMask enclosed = enclosedBlocks(mask, 80);
  EXPECT_TRUE(enclosed.at(100 - 80, 50));
  EXPECT_FALSE(enclosed.at(100 - 81, 50));
  EXPECT_TRUE(enclosed.at(100 + 80, 50));
  EXPECT_FALSE(enclosed.at(100 + 81, 50));
}

TEST(RestoreClothes, UnevenShadeWithinThePersonIsClothes) {
  EXPECT_TRUE(restored({85, 40, 30, 60}, 0.06f).at(100, 90));
}

TEST(RestoreClothes, EvenShadeWithinThePersonStaysShadow) {
  EXPECT_EQ(restored({85, 40, 30, 60}, 0.01f).words(), bodyWithGap().words());
}

TEST(RestoreClothes, TheSameShadeOnTheFloorStaysShadow) {
  EXPECT_EQ(restored({60, 162, 80, 30}, 0.06f).words(), bodyWithGap().words());
}

}  // namespace
}  // namespace markerless_mocap
