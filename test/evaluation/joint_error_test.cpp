#include "evaluation/joint_error.h"

#include <gtest/gtest.h>

#include "evaluation/walking_track.h"

namespace markerless_mocap {
namespace {

constexpr double kExact_mm = 1e-9;

TEST(SummaryStatistics, IsThatOfTheFiniteValues) {
  const SummaryStatistics spread = summaryStatistics({4, NAN, 1, 2, 3, 5});
  EXPECT_EQ(spread.count, 5u);
  EXPECT_DOUBLE_EQ(spread.mean, 3);
  EXPECT_DOUBLE_EQ(spread.median, 3);
  EXPECT_DOUBLE_EQ(spread.p95, 4.8);  // 0.95 of the way along 1 2 3 4 5: between 4 and 5
  EXPECT_DOUBLE_EQ(spread.max, 5);
  EXPECT_DOUBLE_EQ(spread.deviation, std::sqrt(2.0));
  EXPECT_TRUE(std::isnan(summaryStatistics({NAN}).mean));
}

TEST(JointErrors, TruthAgainstItselfIsZero) {
  const JointTrack truth = walkingTrack(20);
  const JointErrors errors = jointErrors(truth, truth);
  EXPECT_EQ(errors.D_spread.max, 0.0);
  EXPECT_EQ(errors.D_mean_unbiased, 0.0);
  EXPECT_EQ(errors.fraction_without_estimate, 0.0);
  EXPECT_EQ(errors.fraction_markers_missing, 0.0);
  EXPECT_EQ(errors.swaps.all, 0.0);
  for (const MarkerError& marker : errors.markers) EXPECT_EQ(marker.max_mm, 0.0) << marker.name;
}

TEST(JointErrors, AShiftOfAllMarkersComesBack) {
  const JointTrack truth = walkingTrack(20);
  JointTrack estimate = truth;
  for (auto& points : estimate.positions) points.colwise() += Eigen::Vector3d(0.03, 0.0, 0.04);
  const JointErrors errors = jointErrors(truth, estimate);
  EXPECT_NEAR(errors.D_spread.mean, 50, kExact_mm);
  EXPECT_NEAR(errors.D_spread.max, 50, kExact_mm);
  for (const MarkerError& marker : errors.markers) EXPECT_NEAR(marker.mean_mm, 50, kExact_mm);
}

TEST(JointErrors, ADefinitionOfJointsThatTurnsWithTheBodyIsToldApart) {
  const JointTrack truth = walkingTrack(30);
  JointTrack estimate = truth;
  const int elbow = truth.indexOf("l_elbow");
  for (int f = 0; f < 30; ++f) {
    const Eigen::AngleAxisd turn(f * kFrame * 1e-9, Eigen::Vector3d::UnitZ());
    estimate.positions[f].col(elbow) += turn * Eigen::Vector3d(0.03, 0.06, 0.02);
  }
  const JointErrors errors = jointErrors(truth, estimate);
  EXPECT_NEAR(errors.D_spread.mean, 70.0 / 15, kExact_mm);
  EXPECT_NEAR(errors.D_mean_unbiased, 0, 1e-6);
  EXPECT_LT((errors.markers[elbow].offset_mm - Eigen::Vector3d(30, 60, 20)).norm(), 1e-6);
  EXPECT_NEAR(errors.markers[elbow].mean_unbiased_mm, 0, 1e-6);
}

TEST(JointErrors, AnErrorThatComesAndGoesIsNoOffset) {
  const JointTrack truth = walkingTrack(20);
  JointTrack estimate = truth;
  for (int f = 0; f < 20; ++f) estimate.positions[f].row(2).array() += f % 2 ? 0.06 : -0.06;
  const JointErrors errors = jointErrors(truth, estimate);
  EXPECT_NEAR(errors.D_mean_unbiased, 60, 1e-6);
  EXPECT_NEAR(errors.D_max_unbiased, 60, 1e-6);
}

TEST(JointErrors, TheLargestErrorIsToldWithoutOffsetsToo) {
  const JointTrack truth = walkingTrack(20);
  JointTrack estimate = truth;
  for (int f = 0; f < 20; ++f) estimate.positions[f].row(2).array() += f == 7 ? 0.30 : 0.10;
  const JointErrors errors = jointErrors(truth, estimate);
  // The offset is the mean, 110 mm.
  EXPECT_NEAR(errors.D_spread.max, 300, 1e-6);
  EXPECT_NEAR(errors.D_max_unbiased, 190, 1e-6);
  EXPECT_NEAR(errors.D_mean_unbiased, (19 * 10 + 190) / 20.0, 1e-6);
}

TEST(JointErrors, SwappedFramesAreCounted) {
  const JointTrack truth = walkingTrack(20);
  JointTrack estimate = truth;
  for (const size_t frame : {3, 7, 8, 15, 19}) swapSides(&estimate, frame);
  const SwapRates swaps = jointErrors(truth, estimate).swaps;
  EXPECT_DOUBLE_EQ(swaps.all, 0.25);
  EXPECT_DOUBLE_EQ(swaps.arms, 0.25);
  EXPECT_DOUBLE_EQ(swaps.legs, 0.25);
}

TEST(JointErrors, SwappedArmsAreToldFromLegs) {
  const JointTrack truth = walkingTrack(20);
  JointTrack estimate = truth;
  for (const char* joint : {"shoulder", "elbow", "wrist"})
    estimate.positions[4]
        .col(truth.indexOf(std::string("l_") + joint))
        .swap(estimate.positions[4].col(truth.indexOf(std::string("r_") + joint)));
  const SwapRates swaps = jointErrors(truth, estimate).swaps;
  EXPECT_DOUBLE_EQ(swaps.arms, 0.05);
  EXPECT_DOUBLE_EQ(swaps.legs, 0.0);
}

TEST(JointErrors, ASwapThatExplainsLessThanThirtyPercentIsNone) {
  const JointTrack truth = walkingTrack(10);
  JointTrack estimate = truth;
  // Sides exchanged, and all of it 2 m away: the exchange explains next to nothing.
  for (size_t f = 0; f < 10; ++f) {
    swapSides(&estimate, f);
    estimate.positions[f].colwise() += Eigen::Vector3d(0, 0, 2);
  }
  EXPECT_EQ(jointErrors(truth, estimate).swaps.all, 0.0);
}

TEST(JointErrors, FramesAndMarkersWithoutEstimateAreCountedAndLeftOut) {
  const JointTrack truth = walkingTrack(20);
  JointTrack estimate = truth;
  for (auto& points : estimate.positions) points.colwise() += Eigen::Vector3d(0.01, 0, 0);
  for (const size_t frame : {0, 1, 2, 3, 4}) lose(&estimate, frame);
  for (size_t f = 5; f < 20; ++f) estimate.positions[f].col(3).setConstant(NAN);
  const JointErrors errors = jointErrors(truth, estimate);
  EXPECT_EQ(errors.frames_estimated, 15u);
  EXPECT_DOUBLE_EQ(errors.fraction_without_estimate, 0.25);
  EXPECT_NEAR(errors.fraction_markers_missing, 1.0 / 15, 1e-12);
  EXPECT_NEAR(errors.D_spread.mean, 10, kExact_mm);
  EXPECT_TRUE(std::isnan(errors.D[4]));
  EXPECT_TRUE(std::isnan(errors.markers[3].mean_mm));
}

TEST(JointErrors, NothingEstimatedIsNoFigure) {
  const JointTrack truth = walkingTrack(4);
  JointTrack estimate = truth;
  for (size_t f = 0; f < 4; ++f) lose(&estimate, f);
  const JointErrors errors = jointErrors(truth, estimate);
  EXPECT_EQ(errors.fraction_without_estimate, 1.0);
  EXPECT_TRUE(std::isnan(errors.D_spread.mean));
  EXPECT_TRUE(std::isnan(errors.swaps.all));
}

TEST(JointErrors, TracksThatDoNotBelongTogetherAreRefused) {
  EXPECT_THROW(jointErrors(walkingTrack(4), walkingTrack(5)), std::invalid_argument);
}

/// Hands 0.8 m apart in ten frames.
JointTrack hands(double off_m) {
  JointTrack track;
  track.names = {"l_hand", "r_hand"};
  for (int f = 0; f < 10; ++f)
    track.add(f, (Eigen::Matrix3Xd(3, 2) << 0, 0, 0.4, -0.4, 1 + off_m, 1 + off_m).finished());
  return track;
}

TEST(Extremities, AreRightWithinTheLimit) {
  EXPECT_DOUBLE_EQ(extremityError(hands(0), hands(0.149), "hand").fraction_correct, 1.0);
  EXPECT_DOUBLE_EQ(extremityError(hands(0), hands(0.151), "hand").fraction_correct, 0.0);
  EXPECT_NEAR(extremityError(hands(0), hands(0.151), "hand").error_mm.mean, 151, kExact_mm);
}

TEST(Extremities, WrongSideOrNoEstimateIsNotRight) {
  JointTrack found = hands(0);
  swapSides(&found, 0);
  lose(&found, 1);
  EXPECT_DOUBLE_EQ(extremityError(hands(0), found, "hand").fraction_correct, 0.8);
  EXPECT_TRUE(std::isnan(extremityError(hands(0), found, "foot").fraction_correct));
}

TEST(Extremities, HandsThatTouchAreHeldAgainstTheNearerOne) {
  JointTrack truth = hands(0);
  for (auto& points : truth.positions) points.row(1) << 0.05, -0.05;
  JointTrack found = truth;
  swapSides(&found, 0);  // each 100 mm off: within the limit, and yet the other hand
  EXPECT_DOUBLE_EQ(extremityError(truth, found, "hand").fraction_correct, 0.9);
}

}  // namespace
}  // namespace markerless_mocap
