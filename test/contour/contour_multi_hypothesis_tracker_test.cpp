#include "contour/track/contour_multi_hypothesis_tracker.h"

#include <gtest/gtest.h>

#include "contour/drawn_body.h"
#include "contour/track/exchanged_sides.h"

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;

constexpr int64_t kFrame_ns = 33333333;

// Of contourPointNames(); each right one is the left one's index + 3.
constexpr Eigen::Index kShoulder = 3, kElbow = 4, kWrist = 5, kHip = 9, kKnee = 10, kAnkle = 11;

ContourOptions fewRays() {
  ContourOptions options;
  options.rays = 400;
  return options;
}

ContourBody drawnBody() {
  return ContourBody(ShapeStatistics::handMade().meanShape(1.75));
}

class ContourHypothesesTest : public ::testing::Test {
 protected:
  ContourObservation see(const ContourPose& pose) const {
    return observer.observe(drawnMasks(rig, body, pose));
  }
  /// The stride, walked on with a swinging arm.
  static ContourPose at(int frame) {
    ContourPose pose = stride();
    pose.position += 0.03 * frame * pose.rotations[B::kRoot].col(0);
    pose.rotations[B::kLeftShoulder] =
        expSO3({0, -0.08 * frame, 0}) * pose.rotations[B::kLeftShoulder];
    pose.angles[A::kRightKnee] -= 0.05 * frame;
    return pose;
  }
  ActiveTrack start(const ContourPose& pose) { return held.start(0, see(at(0)), body, {pose}); }
  ActiveTrack update(int frame) {
    const ContourObservation seen = see(at(frame));
    const ActiveTrack now = held.update(frame * kFrame_ns, seen, body);
    held.improve(seen, body);
    return now;
  }
  ActiveTrack reinitialize(int frame, const ContourPose& pose, const ActiveTrack& now) {
    return held.reinitialize(frame * kFrame_ns, see(at(frame)), body, {pose}, now);
  }
  /// Turned by a right angle.
  static ContourPose sideways(ContourPose pose) {
    pose.rotations[B::kRoot] = expSO3({0, 0, M_PI / 2}) * pose.rotations[B::kRoot];
    return pose;
  }
  double error(const ActiveTrack& now, int frame) const {
    return jointDistance(body, now.track.fit.pose, body, at(frame));
  }

  CameraRig rig = drawnRig(5);
  ContourBody body = drawnBody();
  ContourObserver observer{rig, fewRays()};
  ContourMultiHypothesisTracker held{rig, fewRays()};
};

TEST_F(ContourHypothesesTest, AStartFromTheRightPoseStays) {
  EXPECT_FALSE(held.isUnambiguous()) << "nothing is held yet";
  const ActiveTrack first = start(disturbed(at(0), 0.1, 0.03, 3));
  EXPECT_EQ(first.track.status, ContourTrackingStatus::kTracked);
  EXPECT_TRUE(first.switched);
  EXPECT_LT(error(first, 0), 0.01);
  for (int frame = 1; frame <= 5; ++frame) {
    const ActiveTrack now = update(frame);
    EXPECT_FALSE(now.switched) << frame;
    EXPECT_LT(error(now, frame), 0.01) << frame;
    EXPECT_TRUE(held.isUnambiguous()) << frame;
  }
}

TEST_F(ContourHypothesesTest, AStartFromTheMirroredPoseTurnsAboutWithinSomeInstants) {
  const ActiveTrack first = start(mirrored(body, at(0)));
  EXPECT_GT(error(first, 0), 0.2) << "must start wrong for this test to tell anything";
  EXPECT_TRUE(held.hasAlternative());
  EXPECT_FALSE(held.isUnambiguous());
  int jumps = 0;
  for (int frame = 1; frame <= 10; ++frame) {
    const ActiveTrack now = update(frame);
    jumps += now.switched;
    EXPECT_EQ(held.isUnambiguous(), jumps == 1) << frame << ": undecided until it has turned about";
    EXPECT_EQ(error(now, frame) < 0.02, jumps == 1) << frame;
  }
  EXPECT_EQ(jumps, 1);
  EXPECT_FALSE(held.hasAlternative());
}

TEST_F(ContourHypothesesTest, TakesTheBestOfSomePoses) {
  ContourPose aside = at(0);
  aside.position.y() += 1.5;
  const ActiveTrack first = held.start(
      0, see(at(0)), body, {aside, mirrored(body, at(0)), disturbed(at(0), 0.1, 0.03, 3)});
  EXPECT_LT(error(first, 0), 0.01);
}

TEST_F(ContourHypothesesTest, OfManyPosesAFewAreFittedToTheEnd) {
  std::vector<ContourPose> poses;
  for (const double turn : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    poses.push_back(at(0));
    poses.back().rotations[B::kRoot] = expSO3({0, turn, 0});
    poses.back().position.y() += 0.3;
  }
  poses.push_back(disturbed(at(0), 0.1, 0.03, 3));
  EXPECT_LT(error(held.start(0, see(at(0)), body, poses), 0), 0.01);
}

TEST_F(ContourHypothesesTest, ALaterStartThatFindsTheSameConfirmsIt) {
  const ContourPose first = disturbed(at(0), 0.1, 0.03, 3);
  start(first);
  EXPECT_FALSE(held.isConfirmed());
  const ActiveTrack before = update(2);
  EXPECT_FALSE(held.isConfirmed()) << "following is no start";
  const ActiveTrack now = reinitialize(2, disturbed(at(2), 0.1, 0.03, 5), before);
  EXPECT_TRUE(held.isConfirmed());
  EXPECT_FALSE(now.switched);
  EXPECT_EQ(boxMinus(before.track.fit.pose, now.track.fit.pose).norm(), 0.0) << "and goes on";
  start(first);
  EXPECT_FALSE(held.isConfirmed()) << "another start";
}

TEST_F(ContourHypothesesTest, ALaterStartThatFindsAnArmElsewhereConfirmsTheBody) {
  start(at(0));
  ActiveTrack before = update(1);
  before.track.fit.pose.rotations[B::kLeftShoulder] = expSO3({2.2, 0.3, 0});
  reinitialize(1, at(1), before);
  EXPECT_TRUE(held.isConfirmed());
}

TEST_F(ContourHypothesesTest, ALaterStartThatIsNotClearlyBetterNeitherConfirmsNorReplaces) {
  start(at(0));
  const ActiveTrack before = update(1);
  const ActiveTrack now = reinitialize(1, mirrored(body, at(1)), before);
  EXPECT_FALSE(held.isConfirmed());
  EXPECT_FALSE(now.switched);
  EXPECT_LT(error(now, 1), 0.01);
  EXPECT_LT(error(update(2), 2), 0.01);
}

TEST_F(ContourHypothesesTest, ALaterStartThatIsClearlyBetterReplacesAtOnce) {
  const ActiveTrack first = start(sideways(at(0)));
  ASSERT_GT(error(first, 0), 0.1) << "must start wrong for this test to tell anything";
  const ActiveTrack before = update(1);
  ASSERT_GT(error(before, 1), 0.1);
  const ActiveTrack now = reinitialize(1, disturbed(at(1), 0.1, 0.03, 3), before);
  EXPECT_TRUE(now.switched);
  EXPECT_LT(error(now, 1), 0.01);
  EXPECT_FALSE(held.isConfirmed()) << "it is the first that found this";
  EXPECT_TRUE(held.isUnambiguous());
  EXPECT_LT(error(update(2), 2), 0.01);
}

TEST_F(ContourHypothesesTest, WhatTakesThePlaceOfTheOneConfirmedIsNot) {
  start(mirrored(body, at(0)));
  ActiveTrack now = update(1);
  reinitialize(1, mirrored(body, at(1)), now);
  EXPECT_TRUE(held.isConfirmed());
  EXPECT_FALSE(held.isUnambiguous());
  for (int frame = 2; frame <= 10 && !now.switched; ++frame) now = update(frame);
  ASSERT_TRUE(now.switched);
  EXPECT_FALSE(held.isConfirmed());
}

TEST_F(ContourHypothesesTest, ALaterStartFromNoPoseChangesNothing) {
  start(at(0));
  const ActiveTrack before = update(1);
  const ActiveTrack now = held.reinitialize(kFrame_ns, see(at(1)), body, {}, before);
  EXPECT_EQ(boxMinus(before.track.fit.pose, now.track.fit.pose).norm(), 0.0);
  EXPECT_FALSE(held.isConfirmed());
  EXPECT_TRUE(held.isUnambiguous());
}

TEST_F(ContourHypothesesTest, ChallengeWithTheSamePoseChangesNothing) {
  start(at(0));
  update(1);
  ContourMultiHypothesisTracker other = held;
  other.proposeAlternative(kFrame_ns, see(at(1)), body, {disturbed(at(1), 0.05, 0.02, 7)});
  EXPECT_FALSE(other.hasAlternative());
  EXPECT_TRUE(other.isUnambiguous());
  const ContourPose one = update(2).track.fit.pose;
  const ActiveTrack now = other.update(2 * kFrame_ns, see(at(2)), body);
  EXPECT_FALSE(now.switched);
  EXPECT_EQ(boxMinus(one, now.track.fit.pose).norm(), 0.0);
}

TEST_F(ContourHypothesesTest, ChallengeWithAMuchWorsePoseIsNotHeard) {
  start(at(0));
  update(1);
  held.proposeAlternative(kFrame_ns, see(at(1)), body, {mirrored(body, at(1))});
  EXPECT_FALSE(held.hasAlternative());
  EXPECT_TRUE(held.isUnambiguous());
}

TEST_F(ContourHypothesesTest, ChallengeOfNothingIsNothing) {
  held.proposeAlternative(0, see(at(0)), body, {at(0)});
  EXPECT_FALSE(held.hasAlternative());
  EXPECT_EQ(update(1).track.status, ContourTrackingStatus::kLost);
}

TEST_F(ContourHypothesesTest, FrontAndBackStayUndecidedWhileNothingTellsThemApart) {
  ShapeParameters shape = body.shape();
  shape[BodyLength::kFoot] = 0.03;  // toes are all that tells of one who stands upright
  const ContourBody without_toes(shape);
  ContourPose upright;
  upright.position.z() = 0.92;
  const ContourObservation seen = observer.observe(drawnMasks(rig, without_toes, upright));
  held.start(0, seen, without_toes, {upright});
  for (int i = 1; i <= 10; ++i) {
    EXPECT_TRUE(held.hasAlternative()) << i;
    EXPECT_FALSE(held.isUnambiguous()) << i;
    EXPECT_FALSE(held.update(i * kFrame_ns, seen, without_toes).switched) << i;
  }
  held.lose();
  held.start(0, see(upright), body, {upright});
  EXPECT_TRUE(held.isUnambiguous()) << "with toes it is plain";
}

TEST_F(ContourHypothesesTest, LosesOnEmptyMasksAndWhenToldTo) {
  start(mirrored(body, at(0)));
  const ContourObservation nothing = observer.observe(std::vector<cv::Mat>(rig.size()));
  EXPECT_EQ(held.update(kFrame_ns, nothing, body).track.status, ContourTrackingStatus::kLost);
  EXPECT_FALSE(held.hasAlternative());
  EXPECT_FALSE(held.isUnambiguous());
  start(at(0));
  held.lose();
  EXPECT_FALSE(held.isUnambiguous());
  EXPECT_EQ(update(1).track.status, ContourTrackingStatus::kLost);
}

TEST_F(ContourHypothesesTest, StartsNowhereWithoutMasksOrPoses) {
  const ContourObservation nothing = observer.observe(std::vector<cv::Mat>(rig.size()));
  EXPECT_EQ(held.start(0, nothing, body, {at(0)}).track.status, ContourTrackingStatus::kLost);
  EXPECT_EQ(held.start(0, see(at(0)), body, {}).track.status, ContourTrackingStatus::kLost);
  EXPECT_FALSE(held.isUnambiguous());
}

TEST(Mirrored, WhatWasTheLeftLimbsPlaceIsTheRightOnes) {
  const ContourBody body = drawnBody();
  const Eigen::Matrix3Xd before = body.points(stride());
  const ContourPose about = mirrored(body, stride());
  const Eigen::Matrix3Xd after = body.points(about);
  for (const Eigen::Index joint : {kShoulder, kElbow, kWrist, kHip, kKnee}) {
    EXPECT_LT((after.col(joint) - before.col(joint + 3)).norm(), 1e-9) << joint;
    EXPECT_LT((after.col(joint + 3) - before.col(joint)).norm(), 1e-9) << joint;
  }
  EXPECT_LT((after.leftCols<2>() - before.leftCols<2>()).norm(), 1e-9) << "pelvis and neck";
  EXPECT_LT((about.rotations[B::kRoot].col(0) + stride().rotations[B::kRoot].col(0)).norm(), 1e-9);
  for (const size_t knee : {A::kLeftKnee, A::kRightKnee}) EXPECT_LE(about.angles[knee], 0.0);
}

TEST(Mirrored, TwiceGivesThePlacesBack) {
  const ContourBody body = drawnBody();
  ContourPose straight = stride();
  straight.angles[A::kLeftKnee] = straight.angles[A::kRightKnee] = 0;  // others straighten
  const ContourPose twice = mirrored(body, mirrored(body, straight));
  EXPECT_LT(boxMinus(straight, twice).norm(), 1e-9);
}

TEST(WithLegsExchanged, EachLegLiesAsTheOtherDid) {
  const ContourBody body = drawnBody();
  ContourPose pose = stride();
  pose.angles[A::kLeftAnkle] = 0.2;
  const ContourPose exchanged = withLegsSwapped(body, pose);
  const Eigen::Matrix3Xd before = body.points(pose), after = body.points(exchanged);
  constexpr Eigen::Index kRight = 3;
  for (const Eigen::Index joint : {kKnee, kAnkle})
    for (const Eigen::Index side : {Eigen::Index(0), kRight}) {
      const Eigen::Index hip = kHip + side, other = kRight - side;
      const Eigen::Vector3d was = before.col(joint + other) - before.col(kHip + other);
      EXPECT_LT((after.col(joint + side) - after.col(hip) - was).norm(), 1e-9) << joint;
    }
  EXPECT_LT((after - before).leftCols<kHip + 1>().norm(), 1e-9) << "all above the legs stays";
  EXPECT_EQ(exchanged.angles[A::kRightAnkle], 0.2);
  EXPECT_LT(boxMinus(pose, withLegsSwapped(body, exchanged)).norm(), 1e-9);
}

TEST(IsElsewhere, TellsByHandsAndFeetAlone) {
  const ContourBody body = drawnBody();
  EXPECT_FALSE(limbsDiffer(body, stride(), stride()));
  EXPECT_FALSE(limbsDiffer(body, stride(), disturbed(stride(), 0.03, 0.02, 1)));
  EXPECT_TRUE(limbsDiffer(body, stride(), mirrored(body, stride())));
  EXPECT_TRUE(limbsDiffer(body, stride(), withLegsSwapped(body, stride())));
  for (const size_t hinge : {A::kLeftElbow, A::kRightElbow, A::kLeftKnee, A::kRightKnee}) {
    ContourPose bent = stride();
    bent.angles[hinge] += hinge < A::kLeftKnee ? 1.0 : -1.0;
    EXPECT_TRUE(limbsDiffer(body, stride(), bent)) << hinge;
  }
  ContourPose nodding = stride();
  nodding.rotations[B::kNeck] = expSO3({0, 0.8, 0});
  EXPECT_FALSE(limbsDiffer(body, stride(), nodding));
}

TEST_F(ContourHypothesesTest, ABodyIsTheSameThoughAnArmIsElsewhere) {
  ContourPose raised = at(0);
  raised.rotations[B::kLeftShoulder] = expSO3({0, -0.8, 0}) * raised.rotations[B::kLeftShoulder];
  EXPECT_TRUE(limbsDiffer(body, at(0), raised));
  EXPECT_TRUE(isSameBody(body, at(0), raised));
  EXPECT_FALSE(isSameBody(body, at(0), sideways(at(0))));
}

}  // namespace
}  // namespace markerless_mocap
