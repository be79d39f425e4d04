#include "contour/track/contour_hypothesis_tracker.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <opencv2/imgproc.hpp>

#include "contour/drawn_body.h"
#include "contour/track/exchanged_sides.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kFrame_ns = 33333333;
constexpr Eigen::Index kLeftWrist = 5, kRightWrist = 8;  // of contourPointNames()

class ContourTrackerTest : public ::testing::Test {
 protected:
  ContourTrackerTest()
      : rig(drawnRig(6)),
        body(ShapeStatistics::handMade().meanShape(1.75)),
        tracker(rig, {}),
        observer(rig, {}) {}
  ContourObservation see(const ContourPose& pose) const {
    return observer.observe(drawnMasks(rig, body, pose));
  }
  /// The stride, walked on and with swinging arms.
  static ContourPose at(int frame) {
    ContourPose pose = stride();
    pose.position.x() += 0.03 * frame;
    pose.rotations[SphericalJoint::kLeftShoulder] =
        expSO3({0, -0.08 * frame, 0}) * pose.rotations[SphericalJoint::kLeftShoulder];
    pose.angles[RevoluteJoint::kRightKnee] -= 0.05 * frame;
    return pose;
  }
  /// The left arm on the other side of the body.
  static ContourPose withArmElsewhere(ContourPose pose) {
    pose.rotations[SphericalJoint::kLeftShoulder] = expSO3({2.2, 0.3, 0});
    pose.angles[RevoluteJoint::kLeftElbow] = 0.3;
    return pose;
  }
  /// Forearms and hands thicker than those that are drawn, metres.
  ContourBody withFatForearms(double by) const {
    ShapeParameters shape = body.shape();
    for (const int kind : {int(BodyCone::kForearm), int(BodyCone::kHand)})
      for (const int end : {0, 1}) shape[radiusIndex(kind, end)] += by;
    return ContourBody(shape);
  }

  CameraRig rig;
  ContourBody body;
  ContourHypothesisTracker tracker;
  ContourObserver observer;
};

TEST_F(ContourTrackerTest, FollowsAWalk) {
  EXPECT_FALSE(tracker.tracking());
  tracker.start(0, see(at(0)), body, disturbed(at(0), 0.05, 0.02, 4));
  for (int i = 1; i <= 6; ++i) {
    const ContourTrackingResult track = tracker.update(i * kFrame_ns, see(at(i)), body);
    EXPECT_EQ(track.status, ContourTrackingStatus::kTracked);
    EXPECT_LT(jointDistance(body, track.fit.pose, body, at(i)), 0.012) << i;
  }
}

TEST_F(ContourTrackerTest, TurnedBackItExpectsTheOppositeMotion) {
  tracker.start(0, see(at(0)), body, at(0));
  tracker.update(kFrame_ns, see(at(1)), body);
  const double now = tracker.pose().position.x();
  const double step = tracker.predict(2 * kFrame_ns)->pose.position.x() - now;
  EXPECT_GT(step, 0.01);
  tracker.turnBack();
  EXPECT_NEAR(tracker.predict(2 * kFrame_ns)->pose.position.x() - now, -step, 1e-9);
}

TEST_F(ContourTrackerTest, FollowsThroughCamerasThatTakeTurns) {
  const auto punch = [](double frame) {
    ContourPose pose = at(0);
    pose.position.x() += 0.05 * frame;
    pose.rotations[SphericalJoint::kLeftShoulder] =
        expSO3({0, -0.2 * frame, 0}) * pose.rotations[SphericalJoint::kLeftShoulder];
    return pose;
  };
  std::vector<double> later_s;
  for (size_t i = 0; i < rig.size(); ++i)
    later_s.push_back(1e-9 * kFrame_ns * (double(i % 4) - 1.5) / 4);
  ContourHypothesisTracker unaware(rig, {});
  for (ContourHypothesisTracker* one : {&tracker, &unaware})
    one->start(0, see(punch(0)), body, punch(0));
  double error = 0.0, unaware_error = 0.0;
  for (int i = 1; i <= 7; ++i) {
    std::vector<cv::Mat> masks(rig.size());
    for (size_t c = 0; c < rig.size(); ++c)
      masks[c] = drawnMasks(rig, body, punch(i + 1e9 * later_s[c] / kFrame_ns))[c];
    ContourObservation seen = observer.observe(masks);
    const ContourPose taken = unaware.update(i * kFrame_ns, seen, body).fit.pose;
    if (const auto motion = tracker.motion(i * kFrame_ns))
      shiftViews(body, *motion, later_s, &seen);
    const ContourPose pose = tracker.update(i * kFrame_ns, seen, body).fit.pose;
    if (i < 3) continue;  // two poses tell how it moves
    const auto wristError = [&](const ContourPose& found) {
      return (body.points(found) - body.points(punch(i))).col(kLeftWrist).norm() / 5;
    };
    error += wristError(pose);
    unaware_error += wristError(taken);
  }
  EXPECT_GT(unaware_error, 2 * error) << "m: " << unaware_error << ' ' << error;
  EXPECT_LT(error, 0.012);
}

TEST_F(ContourTrackerTest, FindsAnArmAgainThatWasLost) {
  tracker.start(0, see(at(0)), body, at(0));
  tracker.update(kFrame_ns, see(at(0)), body);
  const ContourPose jumped = withArmElsewhere(at(0));  // between two instants
  const ContourObservation seen = see(jumped);
  const ContourFit alone = tracker.fitter().fit(
      seen, body, at(0), ContourPrediction{at(0), 1.0 / 30}, tracker.fitter().schedule(1.0 / 30));
  ASSERT_GT((body.points(alone.pose) - body.points(jumped)).col(kLeftWrist).norm(), 0.2)
      << "the fit alone must fail for this test to tell anything";
  const ContourTrackingResult track = tracker.update(2 * kFrame_ns, seen, body);
  EXPECT_EQ(track.status, ContourTrackingStatus::kLimbRecovered);
  EXPECT_LT((body.points(track.fit.pose) - body.points(jumped)).col(kLeftWrist).norm(), 0.05);
}

TEST_F(ContourTrackerTest, AnArmThatIsNotSearchedForIsSaidToBeLostUntilItIs) {
  tracker.start(0, see(at(0)), body, at(0));
  tracker.update(kFrame_ns, see(at(0)), body);
  const ContourPose jumped = withArmElsewhere(at(0));
  const ContourObservation seen = see(jumped);
  ContourTrackingResult track = tracker.update(2 * kFrame_ns, seen, body, [] { return false; });
  EXPECT_EQ(track.status, ContourTrackingStatus::kLimbLost);
  track = tracker.update(3 * kFrame_ns, seen, body);
  EXPECT_EQ(track.status, ContourTrackingStatus::kLimbRecovered)
      << "at once, nothing was tried yet";
  EXPECT_LT((body.points(track.fit.pose) - body.points(jumped)).col(kLeftWrist).norm(), 0.05);
}

TEST_F(ContourTrackerTest, OfTwoLostArmsOneIsSearchedForInAFrameIfThereIsNoMoreTime) {
  tracker.start(0, see(at(0)), body, at(0));
  tracker.update(kFrame_ns, see(at(0)), body);
  ContourPose jumped = withArmElsewhere(at(0));
  jumped.rotations[SphericalJoint::kRightShoulder] = expSO3({-2.2, 0.3, 0});
  jumped.angles[RevoluteJoint::kRightElbow] = 0.3;
  const ContourObservation seen = see(jumped);
  const auto foundArms = [&](int frame) {
    int searches = 1;
    const ContourTrackingResult track =
        tracker.update(frame * kFrame_ns, seen, body, [&] { return searches-- > 0; });
    const Eigen::Matrix3Xd off = body.points(track.fit.pose) - body.points(jumped);
    return (off.col(kLeftWrist).norm() < 0.05) + (off.col(kRightWrist).norm() < 0.05);
  };
  EXPECT_EQ(foundArms(2), 1);
  EXPECT_EQ(foundArms(3), 2) << "it goes on with the other one";
}

TEST_F(ContourTrackerTest, LegsThatHavePassedEachOtherInALongStepAreNotExchanged) {
  constexpr Eigen::Index kLeftAnkle = 11, kRightAnkle = 14;
  constexpr int64_t kStep_ns = 333333333;
  tracker.start(0, see(at(0)), body, at(0));
  tracker.update(kStep_ns, see(at(0)), body);
  const ContourPose passed = withLegsSwapped(body, at(0));
  const ContourObservation seen = see(passed);
  const auto off = [&](const ContourPose& pose, Eigen::Index ankle) {
    return (body.points(pose) - body.points(passed)).col(ankle).norm();
  };
  const ContourFit alone =
      tracker.fitter().fit(seen, body, at(0), ContourPrediction{at(0), 1e-9 * kStep_ns},
                           tracker.fitter().schedule(1.0 / 30));
  ASSERT_GT(off(alone.pose, kLeftAnkle), 0.2)
      << "the fit alone must fail for this test to tell anything";
  const ContourFit fit = tracker.update(2 * kStep_ns, seen, body).fit;
  EXPECT_LT(off(fit.pose, kLeftAnkle), 0.05);
  EXPECT_LT(off(fit.pose, kRightAnkle), 0.05);
}

TEST_F(ContourTrackerTest, DoubtsMasksThatNoPoseExplains) {
  tracker.start(0, see(at(0)), body, at(0));
  std::vector<cv::Mat> masks = drawnMasks(rig, body, at(0));
  for (cv::Mat& mask : masks) mask(cv::Rect(20, 20, 30, 30)) = 255;  // no limb reaches there
  const ContourObservation cut = observer.observe(masks);
  EXPECT_EQ(tracker.update(kFrame_ns, cut, body).status, ContourTrackingStatus::kLimbLost);
}

TEST_F(ContourTrackerTest, ALimbThatAlwaysSticksOutByAsMuchIsNotSuspicious) {
  const ContourBody fat = withFatForearms(0.06);
  tracker.start(0, see(at(0)), fat, at(0));
  for (int i = 1; i <= 6; ++i) {
    const ContourTrackingResult track = tracker.update(i * kFrame_ns, see(at(i)), fat);
    EXPECT_GT(track.fit.limbs[ContourLimb::kLeftArm].outside, 0.027) << i;
    EXPECT_EQ(track.status, ContourTrackingStatus::kTracked) << i;
  }
}

TEST_F(ContourTrackerTest, ALimbThatSuddenlySticksOutIsSuspicious) {
  tracker.start(0, see(at(0)), body, at(0));
  EXPECT_EQ(tracker.update(kFrame_ns, see(at(1)), body).status, ContourTrackingStatus::kTracked);
  EXPECT_EQ(tracker.update(2 * kFrame_ns, see(at(2)), withFatForearms(0.06)).status,
            ContourTrackingStatus::kLimbLost)
      << "and no better place is found";
}

TEST_F(ContourTrackerTest, ALimbThatAlwaysSticksOutIsStillFoundAgain) {
  const ContourBody fat = withFatForearms(0.02);
  tracker.start(0, see(at(0)), fat, at(0));
  tracker.update(kFrame_ns, see(at(0)), fat);
  const ContourPose jumped = withArmElsewhere(at(0));
  const ContourTrackingResult track = tracker.update(2 * kFrame_ns, see(jumped), fat);
  EXPECT_EQ(track.status, ContourTrackingStatus::kLimbRecovered);
  EXPECT_LT((body.points(track.fit.pose) - body.points(jumped)).col(kLeftWrist).norm(), 0.05);
}

TEST_F(ContourTrackerTest, AnArmLostFromTheStartOnIsLookedForNowAndThen) {
  const ContourPose truth = withArmElsewhere(at(0));
  const ContourObservation seen = see(truth);
  const ContourFit fit =
      tracker.fitter().fit(seen, body, at(0), std::nullopt, tracker.fitter().schedule(1.0 / 30));
  const auto arm_off = [&](const ContourFit& of) {
    return (body.points(of.pose) - body.points(truth)).col(kLeftWrist).norm();
  };
  ASSERT_GT(arm_off(fit), 0.2) << "must start wrong for this test to tell anything";
  ASSERT_EQ(tracker.startFrom(0, fit).status, ContourTrackingStatus::kTracked);
  std::optional<ContourFit> better;
  for (int frame = 1; frame <= 20 && !better; ++frame) {
    const ContourTrackingResult track = tracker.update(frame * kFrame_ns, seen, body);
    EXPECT_EQ(track.status, ContourTrackingStatus::kTracked);
    better = tracker.improve(seen, body);
    EXPECT_FALSE(tracker.improve(seen, body)) << "once a frame";
  }
  ASSERT_TRUE(better) << "within two thirds of a second";
  EXPECT_LT(arm_off(*better), 0.05);
  const ContourFit next = tracker.update(21 * kFrame_ns, seen, body).fit;
  EXPECT_LT(arm_off(next), 0.05) << "the next frame continues it";
  EXPECT_GT(tracker.quality(), 0.9);
}

TEST_F(ContourTrackerTest, ATrunkThatTurnedAwayInsideWideClothesComesBackWithinTwoInstants) {
  ContourPose hanging;
  hanging.position = stride().position;
  std::vector<cv::Mat> masks = drawnMasks(rig, body, hanging);
  const cv::Mat clothes = cv::getStructuringElement(cv::MORPH_ELLIPSE, {5, 5});
  for (cv::Mat& mask : masks) cv::dilate(mask, mask, clothes);
  const ContourObservation seen = observer.observe(masks);
  ContourPose turned = hanging;
  turned.angles[RevoluteJoint::kSpineTwist] = 1.1;
  turned.angles[RevoluteJoint::kLeftClavicleYaw] = -0.55;
  turned.angles[RevoluteJoint::kRightClavicleYaw] = 0.55;
  const auto shoulders_off = [&](const ContourPose& pose) {
    return (body.points(pose) - body.points(hanging)).col(kLeftWrist - 2).norm();
  };
  ASSERT_GT(shoulders_off(turned), 0.2);
  ContourFit start = tracker.fitter().fit(seen, body, turned, std::nullopt, {1, 0.03, 0.03});
  start.pose = turned;
  ASSERT_EQ(tracker.startFrom(0, start).status, ContourTrackingStatus::kTracked);
  std::optional<ContourFit> better;
  for (int i = 1; i <= 2 && !better; ++i) {
    tracker.update(i * kFrame_ns, seen, body);
    better = tracker.improve(seen, body);
  }
  ASSERT_TRUE(better);
  EXPECT_LT(shoulders_off(better->pose), 0.05);
  EXPECT_LT(shoulders_off(tracker.pose()), 0.05);
}

TEST_F(ContourTrackerTest, ATrunkThatIsTwistedStaysSo) {
  ContourPose twisted = at(0);  // arms away from the body
  twisted.angles[RevoluteJoint::kSpineTwist] = 0.6;
  const ContourObservation seen = see(twisted);
  tracker.start(0, seen, body, twisted);
  for (int i = 1; i <= 6; ++i) {
    const ContourTrackingResult track = tracker.update(i * kFrame_ns, seen, body);
    EXPECT_EQ(track.status, ContourTrackingStatus::kTracked) << i;
    EXPECT_LT(jointDistance(body, track.fit.pose, body, twisted), 0.015) << i;
    EXPECT_FALSE(tracker.improve(seen, body)) << i;
  }
}

TEST_F(ContourTrackerTest, IsLostWithoutMasksAfterAGapAndWhenTimeGoesBack) {
  const ContourObservation seen = see(at(0));
  EXPECT_EQ(tracker.update(0, seen, body).status, ContourTrackingStatus::kLost);
  tracker.start(0, seen, body, at(0));
  const ContourObservation nothing = observer.observe(std::vector<cv::Mat>(rig.size()));
  EXPECT_EQ(tracker.update(kFrame_ns, nothing, body).status, ContourTrackingStatus::kLost);
  EXPECT_FALSE(tracker.tracking());
  tracker.start(0, seen, body, at(0));
  EXPECT_EQ(tracker.update(int64_t(1e9), seen, body).status, ContourTrackingStatus::kLost);
  tracker.start(0, seen, body, at(0));
  EXPECT_EQ(tracker.update(0, seen, body).status, ContourTrackingStatus::kLost);
}

TEST_F(ContourTrackerTest, IsLostWhereNobodyIs) {
  ContourPose elsewhere = at(0);
  elsewhere.position.z() += 3;
  EXPECT_EQ(tracker.start(0, see(at(0)), body, elsewhere).status, ContourTrackingStatus::kLost);
}

TEST_F(ContourTrackerTest, IsTheSameOnAnyNumberOfThreads) {
  const auto on = [&](size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    tracker.start(0, see(at(0)), body, disturbed(at(0), 0.05, 0.02, 4));
    return tracker.update(kFrame_ns, see(at(1)), body).fit.pose;
  };
  EXPECT_EQ(boxMinus(on(1), on(2)).norm(), 0.0);
}

}  // namespace
}  // namespace markerless_mocap
