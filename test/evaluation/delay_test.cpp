#include "evaluation/delay.h"

#include <gtest/gtest.h>

#include "evaluation/walking_track.h"

namespace markerless_mocap {
namespace {

constexpr double kTolerance = 0.001;  // s, a fortieth of the frame time

TEST(Delay, OfTheTruthItselfIsZero) {
  const Delay delay = estimateDelay(walkingTrack(60), walkingTrack(60));
  EXPECT_NEAR(delay.seconds, 0, 1e-6);
  EXPECT_NEAR(delay.D_now_mm, 0, 1e-9);
}

TEST(Delay, ComesBackInFractionsOfAFrame) {
  for (const double late : {0.08, 0.053, -0.04, 0.3}) {
    const Delay delay = estimateDelay(walkingTrack(60), walkingTrack(60, late));
    EXPECT_NEAR(delay.seconds, late, kTolerance) << late;
    EXPECT_LT(delay.D_shifted_mm, 0.1 * delay.D_now_mm) << late;
  }
}

TEST(Delay, IsFoundUnderAConstantOffset) {
  JointTrack estimate = walkingTrack(100, 0.08);
  for (auto& points : estimate.positions) points.colwise() += Eigen::Vector3d(0, 0, 0.05);
  EXPECT_NEAR(estimateDelay(walkingTrack(100), estimate).seconds, 0.08, kTolerance);
}

TEST(Delay, OfSomebodyWhoStandsStillCannotBeTold) {
  JointTrack still = walkingTrack(60);
  for (auto& points : still.positions) points = still.positions[0];
  EXPECT_TRUE(std::isnan(estimateDelay(still, still).seconds));
}

TEST(Delay, TakesFramesEnough) {
  EXPECT_TRUE(std::isnan(estimateDelay(walkingTrack(30), walkingTrack(30)).seconds));
  EXPECT_TRUE(std::isnan(estimateDelay(walkingTrack(1), walkingTrack(1)).seconds));
}

}  // namespace
}  // namespace markerless_mocap
