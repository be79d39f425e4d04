#include "silhouette/shadow/shadow_evidence.h"

#include <gtest/gtest.h>

#include <functional>
#include <opencv2/imgproc.hpp>

namespace markerless_mocap {
namespace {

const cv::Size kSize(200, 200);
constexpr int kSide = ShadowBlocks::kSide;

/// Foreground left, right and below of a gap, as a shirt on trousers has it.
BitMask bodyWithGap() {
  cv::Mat mask = cv::Mat::zeros(kSize, CV_8UC1);
  cv::rectangle(mask, {60, 40, 80, 120}, 255, cv::FILLED);
  cv::rectangle(mask, {85, 40, 30, 60}, 0, cv::FILLED);
  return BitMask::fromMat(mask);
}

constexpr BlockShadowThresholds kColor{false, 1, 0.02f, 0}, kGrey{true, 1, 0.02f, 0};

using Texture = std::function<cv::Vec3b(int x, int y)>;

/// Blocks of an area whose pixels are darker versions of grey 100; the pixels are set in `shadow`.
ShadowBlocks blocksOf(const cv::Rect& area, const Texture& texture, BitMask* shadow) {
  ShadowBlocks blocks;
  blocks.resize(kSize);
  for (int row = 0; row < blocks.rows(); ++row)
    for (int word = 0; word < shadow->rowWords(); ++word) {
      ShadowColumns columns;
      for (int y = kSide * row; y < kSide * (row + 1); ++y)
        for (int x = 64 * word; x < std::min(64 * (word + 1), kSize.width); ++x) {
          if (!area.contains({x, y})) continue;
          shadow->set(x, y);
          const cv::Vec3b color = texture(x, y);
          const int i = x - 64 * word, ratio = 127 * (color[0] + color[1] + color[2]) / 300;
          ++columns.count[i];
          for (int c = 0; c < 3; ++c) {
            columns.now[c][i] = uint16_t(columns.now[c][i] + color[c]);
            columns.expected[c][i] = uint16_t(columns.expected[c][i] + 100);
          }
          columns.ratio[i] = uint16_t(columns.ratio[i] + ratio);
          columns.squares[i] = uint16_t(columns.squares[i] + ratio * ratio);
        }
      blocks.add(columns, word, row);
    }
  return blocks;
}

/// The body after restoreFalseShadows() if `area` is full of such pixels.
BitMask restored(const cv::Rect& area, const BlockShadowThresholds& limits,
                 const Texture& texture) {
  BitMask shadow(kSize), mask = bodyWithGap();
  const ShadowBlocks blocks = blocksOf(area, texture, &shadow);
  restoreFalseShadows(blocks, limits, &shadow, &mask);
  return mask;
}

/// Of a brightness ratio of 0.7 with stripes of `contrast`.
Texture stripes(int contrast) {
  return [=](int x, int) { return cv::Vec3b::all(uchar(70 + (x % 2 ? contrast : -contrast))); };
}

/// As bright, but not as grey as the background.
cv::Vec3b reddish(int, int) {
  return {69, 69, 72};
}

/// The same with noise far greater than the colour.
cv::Vec3b noisyReddish(int x, int y) {
  return (x + y) % 2 ? cv::Vec3b(74, 64, 72) : cv::Vec3b(64, 74, 72);
}

const cv::Rect kGap(85, 40, 30, 60), kFloor(60, 162, 80, 30);

TEST(ShadowBlocks, SumsAreOverNineBlocks) {
  BitMask shadow(kSize);
  const ShadowBlocks blocks = blocksOf({63, 7, 2, 2}, stripes(10), &shadow);  // where words meet
  const ShadowBlocks::Sums one = blocks.at(15, 1), all = blocks.around(15, 1);
  EXPECT_EQ(one.count, 1);
  EXPECT_EQ(one.now[0], 80);
  EXPECT_EQ(all.count, 4);
  EXPECT_EQ(all.now[2], 2 * (80 + 60));
  EXPECT_EQ(all.expected[1], 400);
  EXPECT_EQ(all.degrees_of_freedom, 0) << "one pixel of each block cannot vary";
  EXPECT_TRUE(blocks.isEmpty(17, 1));
}

TEST(ShadowBlocks, UnevennessIsWithinBlocks) {
  BitMask shadow(kSize);
  const auto steps = [](int x, int) { return cv::Vec3b::all(x < 44 ? 60 : 80); };
  EXPECT_EQ(blocksOf({40, 8, 8, 4}, steps, &shadow).around(10, 2).uneven, 0);
  const ShadowBlocks::Sums folds = blocksOf({40, 8, 8, 4}, stripes(10), &shadow).around(10, 2);
  EXPECT_NEAR(folds.uneven / 32, 0.1 * 0.1, 5e-4);
  EXPECT_EQ(folds.degrees_of_freedom, 30);
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
  EXPECT_TRUE(restored(kGap, kGrey, stripes(5)).at(100, 90));
  EXPECT_TRUE(restored(kGap, kColor, stripes(12)).at(100, 90));
}

TEST(RestoreClothes, EvenShadeWithinThePersonStaysShadow) {
  EXPECT_EQ(restored(kGap, kGrey, stripes(1)).words(), bodyWithGap().words());
  EXPECT_EQ(restored(kGap, kColor, stripes(1)).words(), bodyWithGap().words());
}

TEST(RestoreClothes, TheSameShadeOnTheFloorStaysShadow) {
  EXPECT_EQ(restored(kFloor, kGrey, stripes(5)).words(), bodyWithGap().words());
}

TEST(RestoreClothes, ColorTellsClothesFromShadow) {
  EXPECT_TRUE(restored(kFloor, kColor, reddish).at(100, 170));
  EXPECT_TRUE(restored(kFloor, kColor, noisyReddish).at(100, 170)) << "noise cancels";
  const BlockShadowThresholds tolerant{false, 1, 0.05f, 0};
  EXPECT_EQ(restored(kFloor, tolerant, reddish).words(), bodyWithGap().words());
}

TEST(RestoreClothes, WithinThePersonLessColorIsEnough) {
  const auto pale = [](int, int) { return cv::Vec3b(69, 69, 71); };
  EXPECT_TRUE(restored(kGap, kColor, pale).at(100, 90));
  EXPECT_EQ(restored(kFloor, kColor, pale).words(), bodyWithGap().words());
}

TEST(RestoreClothes, WhatNoiseMayCauseIsNoEvidence) {
  const BlockShadowThresholds noisy{false, 1, 0.02f, 20 * 20};
  EXPECT_EQ(restored(kFloor, noisy, reddish).words(), bodyWithGap().words());
}

}  // namespace
}  // namespace markerless_mocap
