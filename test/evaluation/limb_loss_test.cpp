#include "evaluation/limb_loss.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "evaluation/walking_track.h"

namespace markerless_mocap {
namespace {

constexpr int kFrames = 50;

TEST(LimbLoss, ATrackThatIsRightLosesNothing) {
  const JointTrack truth = walkingTrack(kFrames);
  const auto limbs = limbLosses(truth, truth);
  ASSERT_EQ(limbs.size(), 5u);
  for (const LimbLoss& limb : limbs) {
    EXPECT_EQ(limb.frames, size_t(kFrames)) << limb.limb;
    EXPECT_EQ(limb.per_minute, 0.0) << limb.limb;
    EXPECT_EQ(limb.fraction_lost, 0.0) << limb.limb;
  }
}

TEST(LimbLoss, CountsWhatIsFarOffOrNotPublishedAfterTheFirstPose) {
  const JointTrack truth = walkingTrack(kFrames);
  JointTrack estimate = truth;
  for (size_t f = 0; f < 5; ++f) lose(&estimate, f);
  const int wrist = truth.indexOf("l_wrist"), other = truth.indexOf("r_wrist");
  for (const size_t f : {10, 11, 12, 13, 14, 17, 18}) estimate.positions[f](0, wrist) += 0.2;
  for (const size_t f : {30, 31}) estimate.positions[f].col(wrist).setConstant(NAN);
  for (size_t f = 5; f < kFrames; ++f) estimate.positions[f](2, other) += 0.149;
  const auto limbs = limbLosses(truth, estimate);
  const LimbLoss& arm = limbs[1];
  EXPECT_EQ(arm.limb, "left_arm");
  EXPECT_EQ(arm.frames, 45u);
  EXPECT_EQ(arm.far_off, 7u);
  EXPECT_EQ(arm.not_published, 2u);
  EXPECT_EQ(arm.losses, 2u);                         // 0.08 s between the first two: one
  EXPECT_NEAR(arm.longest_s, 0.36, 1e-9);            // from frame 10 to frame 19
  EXPECT_NEAR(arm.per_minute, 2 * 60 / 1.76, 1e-9);  // from frame 5 to frame 49
  EXPECT_EQ(arm.fraction_lost, 0.2);
  EXPECT_TRUE(arm.lost[17]);
  EXPECT_FALSE(arm.lost[15]);
  EXPECT_EQ(limbs[2].losses, 0u);
}

TEST(LimbLoss, FramesWithoutPoseLoseAllLimbs) {
  const JointTrack truth = walkingTrack(kFrames);
  JointTrack estimate = truth;
  for (size_t f = 20; f < 30; ++f) lose(&estimate, f);
  for (const LimbLoss& limb : limbLosses(truth, estimate)) {
    EXPECT_EQ(limb.not_published, 10u) << limb.limb;
    EXPECT_EQ(limb.losses, 1u) << limb.limb;
  }
}

TEST(LimbLoss, WithoutAnyPoseThereIsNothingToLose) {
  const JointTrack truth = walkingTrack(kFrames);
  JointTrack estimate = truth;
  for (size_t f = 0; f < kFrames; ++f) lose(&estimate, f);
  for (const LimbLoss& limb : limbLosses(truth, estimate)) {
    EXPECT_EQ(limb.losses, 0u) << limb.limb;
    EXPECT_TRUE(std::isnan(limb.per_minute)) << limb.limb;
    EXPECT_TRUE(std::isnan(limb.fraction_lost)) << limb.limb;
  }
}

TEST(LimbLoss, TakesTracksOfTheSameFrames) {
  EXPECT_THROW(limbLosses(walkingTrack(3), walkingTrack(2)), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
