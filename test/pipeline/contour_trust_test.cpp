/// Which poses are reported where something has gone wrong.
#include "pipeline/contour_method.h"

namespace markerless_mocap {
namespace {

class ContourTrustTest : public ContourMethodTest {};

TEST_F(ContourTrustTest, APoseThatFitsWorseThanUsualIsNotReportedSoonAfterAGap) {
  makeMeasured();
  for (int frame = 0; frame < 45; ++frame)
    ASSERT_NE(show(frame).status, PoseStatus::kLost) << frame;
  stamp_ns += 300000000;
  const BodyPose doubted = show(masksWithoutHands(45), PoseTree{});
  EXPECT_EQ(doubted.status, PoseStatus::kLost);
  EXPECT_EQ(doubted.reason, "a person was found again, but no pose fits as well as before yet");
  EXPECT_NE(showMasks(46).status, PoseStatus::kLost) << "it fits as usual";
}

TEST_F(ContourTrustTest, APoseThatAnotherStartConfirmsIsReportedIfItFitsNearlyAsUsual) {
  makeMeasured();
  for (int frame = 0; frame < 45; ++frame)
    ASSERT_NE(show(frame).status, PoseStatus::kLost) << frame;
  stamp_ns += 300000000;
  int frame = 45;
  const auto showLarger = [&] { return show(enlarged(frame), treeOf(person, at(frame), false)); };
  EXPECT_EQ(show(enlarged(frame), PoseTree{}).reason,
            "a person was found again, but no pose fits as well as before yet");
  ++frame;
  while (showLarger().status == PoseStatus::kLost) ASSERT_LT(++frame, 45 + 15) << "half a second";
  EXPECT_LT(error(showLarger(), frame), 0.04);
}

TEST_F(ContourTrustTest, NoPoseIsReportedWhileThePoseFitsFarWorseThanUsual) {
  makeMeasured();
  for (int frame = 0; frame < 45; ++frame)
    ASSERT_NE(show(frame).status, PoseStatus::kLost) << frame;
  for (int frame = 45; frame < 100; ++frame) {
    const BodyPose pose = show(covered(frame, {0, 2, 3}), PoseTree{});
    EXPECT_EQ(pose.status, PoseStatus::kLost) << frame;
    EXPECT_EQ(
        pose.reason,
        "no pose fits nearly as well as before: cameras may be covered, out of focus or moved");
  }
  int frame = 100;
  while (show(frame).status == PoseStatus::kLost) ASSERT_LT(++frame, 115);
  EXPECT_LT(error(show(frame + 1), frame + 1), 0.02);
}

TEST_F(ContourTrustTest, TwoCoveredCamerasOfFiveCostNoPose) {
  makeMeasured();
  for (int frame = 0; frame < 45; ++frame)
    ASSERT_NE(show(frame).status, PoseStatus::kLost) << frame;
  for (int frame = 45; frame < 100; ++frame) {
    const BodyPose pose = show(covered(frame, {0, 2}), PoseTree{});
    ASSERT_EQ(pose.status, PoseStatus::kTracked) << frame << " " << pose.reason;
    EXPECT_LT(error(pose, frame), 0.02) << frame;
    EXPECT_EQ(pose.reason, "left out, as most other cameras contradict their masks: " +
                               rig[0].name() + ", " + rig[2].name());
  }
  const BodyPose after = show(100);
  EXPECT_EQ(after.status, PoseStatus::kTracked) << "nor is one doubted afterwards";
  EXPECT_EQ(after.reason, "");
}

TEST_F(ContourTrustTest, CamerasThatAreSlowAreNoGap) {
  makeMeasured();
  for (int frame = 0; frame < 30; ++frame) {
    stamp_ns += 250000000;
    ASSERT_NE(show(frame).status, PoseStatus::kLost) << frame;
  }
  stamp_ns += 250000000;
  EXPECT_NE(show(masksWithoutHands(30), PoseTree{}).status, PoseStatus::kLost);
}

}  // namespace
}  // namespace markerless_mocap
