#include "contour/measure/likely_stature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace markerless_mocap {
namespace {

/// The likely stature of somebody who is that tall, expected to be 1.75 m.
double likelyStatureOf(double true_stature) {
  return likelyStature(1.75,
                       [&](double stature) { return 1.0 - std::abs(stature - true_stature); });
}

TEST(LikelyStatureTest, IsTheBestOfTheUsualOnes) {
  EXPECT_DOUBLE_EQ(likelyStatureOf(1.62), 1.6);
  EXPECT_DOUBLE_EQ(likelyStatureOf(1.76), 1.75);
}

TEST(LikelyStatureTest, GoesBeyondTheUsualOnes) {
  EXPECT_NEAR(likelyStatureOf(1.2), 1.2, 1e-9);
  EXPECT_NEAR(likelyStatureOf(2.2), 2.2, 1e-9);
}

TEST(LikelyStatureTest, IsNotThatOfWhatIsNoWholePerson) {
  EXPECT_NEAR(likelyStatureOf(0.7), 1.2, 1e-9);
}

TEST(LikelyStatureTest, IsTheExpectedOneIfNoneFits) {
  EXPECT_DOUBLE_EQ(likelyStature(1.75, [](double) { return 0.0; }), 1.75);
}

RatedStature betterThan(double from, double true_stature) {
  const auto quality = [&](double stature) { return 1.0 - std::abs(stature - true_stature); };
  return betterStature({from, quality(from)}, quality);
}

TEST(LikelyStatureTest, ABetterOneIsLargerOrSmaller) {
  EXPECT_NEAR(betterThan(1.75, 2.3).stature, 2.35, 1e-9);
  EXPECT_NEAR(betterThan(1.75, 2.3).quality, 0.95, 1e-9);
  EXPECT_NEAR(betterThan(1.75, 1.2).stature, 1.15, 1e-9);
  EXPECT_NEAR(betterThan(1.75, 4.0).stature, 2.35, 1e-9) << "no person";
  EXPECT_DOUBLE_EQ(betterThan(1.75, 1.8).stature, 1.75);
}

}  // namespace
}  // namespace markerless_mocap
