#include "motion/clip_editing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "error_text_of.h"
#include "motion/clip_editing_walk.h"

namespace markerless_mocap {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

TEST(Placement, cutsTimes) {
  const MotionClip clip = walk(4.0), piece = cut(clip, 1.0, 2.0);
  EXPECT_DOUBLE_EQ(piece.fps, kFps);
  EXPECT_NEAR(piece.duration(), 2.0, 1e-9);
  EXPECT_NEAR((piece.poses.front().hips - walkingAt(1.0).hips).norm(), 0.0, 1e-9);
  EXPECT_NEAR((piece.poses.back().hips - walkingAt(3.0).hips).norm(), 0.0, 1e-9);
  EXPECT_NEAR(cut(clip, 3.0, 100.0).duration(), 1.0, 1e-9);
  EXPECT_NEAR(cut(clip, 3.0, HUGE_VAL).duration(), 1.0, 1e-9);
}

TEST(Placement, cutsOutsideTheMotionAreRefused) {
  const MotionClip clip = walk(4.0);
  EXPECT_EQ(errorTextOf([&] { cut(clip, 4.5, 1.0); }),
            "start is 4.5 s, allowed is 0 to the motion's 4 s");
  EXPECT_EQ(errorTextOf([&] { cut(clip, -1.0, 1.0); }),
            "start is -1 s, allowed is 0 to the motion's 4 s");
  EXPECT_EQ(errorTextOf([&] { cut(clip, 1.0, 0.0); }), "duration is 0 s, allowed is more than 0");
}

TEST(Placement, turnsAboutTheWorldsAxis) {
  const MotionClip clip = walk(1.0), now = turned(clip, M_PI / 2);
  const HumanPose& before = clip.poses[30];
  const HumanPose& after = now.poses[30];
  EXPECT_NEAR((after.hips - Vector3d(-before.hips.y(), before.hips.x(), before.hips.z())).norm(),
              0.0, 1e-12);
  EXPECT_NEAR((after[Bone::kChest] * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 0.0, 1e-12);
}

TEST(Placement, centresTheBoxOfThePath) {
  const MotionClip clip = centred(turned(walk(3.0), 0.7));
  Eigen::AlignedBox3d box;
  for (const HumanPose& pose : clip.poses) box.extend(pose.hips);
  EXPECT_NEAR(box.center().head<2>().norm(), 0.0, 1e-12);
  EXPECT_NEAR(clip.poses[0].hips.z(), walkingAt(0.0).hips.z(), 1e-12);
}

TEST(Placement, bendingKeepsSteps) {
  const MotionClip clip = walk(6.0);
  for (const double radius : {1.0, -2.0}) {
    const MotionClip round = bent(clip, radius);
    for (size_t i = 1; i < clip.poses.size(); ++i)
      EXPECT_NEAR((round.poses[i].hips - round.poses[i - 1].hips).norm(),
                  (clip.poses[i].hips - clip.poses[i - 1].hips).norm(), 1e-12);
  }
}

// A straight walk of 2 pi r comes round to where it began, left about (0, r), and never leaves the
// circle by more than the sway and what the chords of the steps cut off.
TEST(Placement, bendingWindsAStraightPathOnACircle) {
  for (const double radius : {1.5, -1.5}) {
    const MotionClip round = bent(walk(2.0 * M_PI * 1.5 / kSpeed), radius);
    for (const HumanPose& pose : round.poses)
      EXPECT_NEAR((pose.hips.head<2>() - Eigen::Vector2d(0.0, radius)).norm(), 1.5, 0.045);
    EXPECT_NEAR((round.poses.back().hips - round.poses.front().hips).norm(), 0.0, 0.05);
    // The person faces the way ahead.
    const HumanPose quarter = round.poses[round.poses.size() / 4];
    const Vector3d facing = quarter[Bone::kChest] * Vector3d::UnitX();
    EXPECT_GT(facing.y() * (radius > 0.0 ? 1.0 : -1.0), 0.99);
  }
}

TEST(Placement, tooTightBendsAreRefused) {
  EXPECT_EQ(errorTextOf([] { bent(walk(1.0), 0.05); }),
            "the radius to bend the path by is 0.05 m, allowed is 0.1 m or more to either side");
}

TEST(Placement, soleHeightIsThatOfTheLowestPoint) {
  HumanPose pose = standing();
  EXPECT_NEAR(soleHeight(person(), pose), 0.0, 1e-12);
  pose.hips.z() += 0.3;
  EXPECT_NEAR(soleHeight(person(), pose), 0.3, 1e-12);
  // Toes straight down reach by their length below the ball, and the sole lies before them.
  pose[Bone::kLeftToes] = turn(M_PI / 2, Vector3d::UnitY());
  const double toes = person().lengthOf(Bone::kLeftToes);
  EXPECT_NEAR(soleHeight(person(), pose), 0.3 + person().headOf(Bone::kLeftToes).z() - toes, 1e-9);
}

TEST(Placement, onFloorStandsOnIt) {
  MotionClip clip = walk(4.0);
  for (HumanPose& pose : clip.poses) pose.hips.z() += 0.37 - 0.01 * pose.hips.x();
  const MotionClip low = onFloor(clip, person());
  for (const HumanPose& pose : low.poses) {
    EXPECT_LT(soleHeight(person(), pose), 0.003);
    EXPECT_GT(soleHeight(person(), pose), -0.0035);
  }
  // Nobody is thrown up and down for it.
  EXPECT_LT(mostSteps(low).hips, 1.3 * mostSteps(clip).hips);
}

// A height that falls and rises at 0.4 m/s: one smoothing over 30 ms alone would leave 9 mm where
// it turns.
TEST(Placement, onFloorFollowsFeetClosely) {
  MotionClip clip;
  clip.fps = 100.0;
  for (int i = 0; i < 200; ++i) {
    clip.poses.push_back(standing());
    clip.poses.back().hips.z() += 0.4 * std::abs(std::remainder(i / clip.fps, 0.2));
  }
  for (const HumanPose& pose : onFloor(clip, person()).poses) {
    EXPECT_LT(soleHeight(person(), pose), 0.006);
    EXPECT_GT(soleHeight(person(), pose), -0.0035);
  }
}

TEST(Placement, onFloorBendsToesUpInsteadOfLiftingThePerson) {
  MotionClip clip;
  clip.fps = kFps;
  clip.poses.assign(50, standing());
  for (HumanPose& pose : clip.poses) pose[Bone::kLeftToes] = turn(0.7, Vector3d::UnitY());
  const MotionClip low = onFloor(clip, person());
  EXPECT_NEAR((low.poses[25].hips - standing().hips).norm(), 0.0, 1e-9);
  EXPECT_NEAR(low.poses[25][Bone::kLeftToes].angularDistance(Quaterniond::Identity()), 0.0, 1e-6);
  EXPECT_NEAR(soleHeight(person(), low.poses[25]), 0.0, 1e-6);
}

/// On the tips of upright feet, which no toes can bend to.
MotionClip onTips() {
  MotionClip clip;
  clip.fps = kFps;
  clip.poses.assign(50, standing());
  for (HumanPose& pose : clip.poses)
    for (Bone bone : {Bone::kLeftFoot, Bone::kLeftToes})
      pose[bone] = pose[mirrorOf(bone)] = turn(M_PI / 2, Vector3d::UnitY());
  return clip;
}

TEST(Placement, onFloorRaisesWhoWouldSink) {
  const MotionClip low = onFloor(onTips(), person());
  EXPECT_GT(soleHeight(person(), low.poses[25]), -0.0035);
  EXPECT_LT(soleHeight(person(), low.poses[25]), 0.001);
}

// A leap of 0.6 s and 9.81 m/s2 rises 0.44 m; its height must stay though no foot is down.
TEST(Placement, onFloorKeepsLeaps) {
  MotionClip clip;
  clip.fps = kFps;
  for (int i = 0; i < 100; ++i) {
    const double t = i / kFps - 0.7;
    HumanPose pose = standing();
    pose.hips.z() += 0.1 + (t > 0.0 && t < 0.6 ? 0.5 * 9.81 * t * (0.6 - t) : 0.0);
    clip.poses.push_back(pose);
  }
  const MotionClip low = onFloor(clip, person());
  double maximum = 0.0;
  for (const HumanPose& pose : low.poses) maximum = std::max(maximum, soleHeight(person(), pose));
  EXPECT_NEAR(maximum, 0.5 * 9.81 * 0.3 * 0.3, 0.01);
  EXPECT_NEAR(soleHeight(person(), low.poses.front()), 0.0, 0.003);
  EXPECT_NEAR(soleHeight(person(), low.poses.back()), 0.0, 0.003);
}

TEST(Placement, extendingRepeatsTheCycleWithoutASeam) {
  const MotionClip clip = walk(2.5), longer = extended(clip, 9.0);
  EXPECT_NEAR(longer.duration(), 9.0, 1e-9);
  const Steps was = mostSteps(clip), is = mostSteps(longer);
  EXPECT_LT(is.hips, 1.15 * was.hips);
  EXPECT_LT(is.turn, 1.15 * was.turn);
  // It walks on as fast and straight as before.
  EXPECT_NEAR(longer.poses.back().hips.x(), 9.0 * kSpeed, 0.1);
  EXPECT_NEAR(longer.poses.back().hips.y(), 0.0, 0.1);
}

// The arms rise by 0.12 rad per cycle, nearly twice the fastest step of the walk.
TEST(Placement, extendingFadesWhatNearlyFits) {
  MotionClip clip = walk(2.5);
  for (size_t i = 0; i < clip.poses.size(); ++i)
    for (Bone bone : {Bone::kLeftUpperArm, Bone::kLeftForearm, Bone::kLeftHand})
      clip.poses[i][bone] = turn(0.12 * double(i) / kFps, Vector3d::UnitX()) * clip.poses[i][bone];
  EXPECT_LT(mostSteps(extended(clip, 9.0)).turn, 1.25 * mostSteps(clip).turn);
}

TEST(Placement, extendingBridgesWhatDoesNotFit) {
  MotionClip clip;
  clip.fps = kFps;
  for (int i = 0; i <= 60; ++i) {
    HumanPose pose = standing();
    for (int b = int(Bone::kLeftClavicle); b < kBoneCount; ++b)
      pose[Bone(b)] = turn(1.5 * i / 60.0, Vector3d::UnitY());
    clip.poses.push_back(pose);
  }
  const MotionClip longer = extended(clip, 5.0);
  EXPECT_NEAR(longer.duration(), 5.0, 1e-9);
  // At most 1.5 rad in 0.6 s, eased: 1.5 times the mean speed.
  EXPECT_LT(mostSteps(longer).turn, 1.6 * 1.5 / (0.6 * kFps));
}

TEST(Placement, extendingTurnsEachRepetitionWhereTheLastOneLed) {
  const MotionClip round = bent(walk(2.0), 2.0), longer = extended(round, 8.0);
  const Steps was = mostSteps(round), is = mostSteps(longer);
  EXPECT_LT(is.hips, 1.2 * was.hips);
  for (const HumanPose& pose : longer.poses)
    EXPECT_NEAR((pose.hips.head<2>() - Eigen::Vector2d(0.0, 2.0)).norm(), 2.0, 0.15);
}

TEST(Placement, whatIsLongEnoughStaysAsItIs) {
  const MotionClip clip = walk(2.0);
  EXPECT_EQ(extended(clip, 1.0).poses.size(), clip.poses.size());
  MotionClip still;
  still.fps = kFps;
  still.poses.assign(1, standing());
  EXPECT_NEAR(extended(still, 2.0).duration(), 2.0, 1e-9);
}

Eigen::AlignedBox3d stage(double half, double minimum) {
  return {Vector3d(-half, -half, minimum), Vector3d(half, half, 2.5)};
}

TEST(Placement, whoStaysInsideLeavesNoVolume) {
  EXPECT_EQ(volumeViolation(centred(walk(1.0)), person(), stage(2.0, -0.1)), "");
}

TEST(Placement, standingOnTheFloorOfAVolumeIsInsideIt) {
  MotionClip clip = onFloor(centred(walk(2.0)), person());
  EXPECT_EQ(volumeViolation(clip, person(), stage(3.0, 0.0)), "");
  EXPECT_EQ(volumeViolation(onFloor(onTips(), person()), person(), stage(3.0, 0.0)), "");
  for (HumanPose& pose : clip.poses) pose.hips.z() -= 0.1;
  EXPECT_NE(volumeViolation(clip, person(), stage(3.0, 0.0)), "");
}

TEST(Placement, leavingAVolumeIsToldWithPlaceTimeAndRemedy) {
  MotionClip clip;
  clip.fps = 10.0;
  clip.poses.assign(20, standing());
  clip.poses[12].hips.y() += 0.5;
  const double reach = person().tailOf(Bone::kLeftHand).y() + 0.5;
  char told[200];
  std::snprintf(
      told, sizeof(told),
      "the motion reaches y = %.2f m at 1.2 s, the volume ends at 1.10 m; shorten, centre "
      "or bend it",
      reach);
  EXPECT_EQ(volumeViolation(clip, person(), stage(1.1, -0.1)), told);
}

TEST(Placement, clipsWithoutPosesAreRefused) {
  const MotionClip none{30.0, {}};
  const std::string sentence = "the motion has no poses";
  EXPECT_EQ(errorTextOf([&] { cut(none, 0.0, 1.0); }), sentence);
  EXPECT_EQ(errorTextOf([&] { turned(none, 1.0); }), sentence);
  EXPECT_EQ(errorTextOf([&] { centred(none); }), sentence);
  EXPECT_EQ(errorTextOf([&] { bent(none, 1.0); }), sentence);
  EXPECT_EQ(errorTextOf([&] { onFloor(none, person()); }), sentence);
  EXPECT_EQ(errorTextOf([&] { extended(none, 1.0); }), sentence);
}

}  // namespace
}  // namespace markerless_mocap
