#include "contour/track/color_check.h"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

#include "contour/track/default_postures.h"
#include "contour/unknown_room.h"

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;

/// The thread of a check has a low priority.
void rest() {
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

class ColorCheckTest : public testing::Test, protected UnknownRoom {
 protected:
  ColorQuestion ask(const ContourPose& tracked, std::vector<ContourPose> proposals) const {
    return {RegionObserver(rig, ContourOptions()),
            ContourMultiHypothesisTracker(rig, ContourOptions()),
            RegionFrame(images, masks),
            hull,
            body,
            tracked,
            std::move(proposals)};
  }
  /// Of the joints, metres.
  double error(const ContourPose& found) const {
    return (body.points(found) - body.points(pose)).colwise().norm().mean();
  }
  const ContourPose wrong = [this] {
    ContourPose turned = pose;
    turned.rotations[B::kRoot] = expSO3({0, 0, M_PI / 2}) * pose.rotations[B::kRoot];
    return turned;
  }();
};

TEST_F(ColorCheckTest, ThePoseThatIsTrackedIsConfirmedIfItIsRight) {
  const auto found = answered(ask(disturbed(pose, 0.04, 0.02, 1), {wrong}));
  ASSERT_TRUE(found);
  EXPECT_LT(error(found->fit.pose), 0.03);
}

TEST_F(ColorCheckTest, AnotherIsFoundIfTheTrackedOneIsWrong) {
  ASSERT_TRUE(limbsDiffer(body, wrong, pose));
  const auto found = answered(ask(wrong, {disturbed(pose, 0.04, 0.02, 1)}));
  ASSERT_TRUE(found);
  EXPECT_LT(error(found->fit.pose), 0.03);
}

TEST_F(ColorCheckTest, OfTwoPosesColoursPreferTheRightOne) {
  const ColorQuestion question = ask(pose, {});
  const auto chosen = [&](const ContourPose& tracked, const ContourPose& rival) {
    return preferred(question.scene(), tracked, rival).value().fit;
  };
  EXPECT_LT(error(chosen(wrong, disturbed(pose, 0.04, 0.02, 1)).pose), 0.03);
  EXPECT_LT(error(chosen(disturbed(pose, 0.04, 0.02, 1), wrong).pose), 0.03);
}

TEST_F(ColorCheckTest, NothingIsPreferredWhereNobodyIsSeen) {
  for (cv::Mat& mask : masks) mask.setTo(0);
  for (cv::Mat& image : images) image.release();
  const ColorQuestion question = ask(pose, {});
  EXPECT_FALSE(preferred(question.scene(), pose, wrong).has_value());
}

TEST_F(ColorCheckTest, InAnotherThreadTheAnswerIsTheSame) {
  const auto expected = answered(completed(ask(wrong, {pose})));
  ASSERT_TRUE(expected);
  ColorCheck check;
  EXPECT_FALSE(check.isBusy());
  EXPECT_FALSE(check.answer());
  check.ask(ask(wrong, {pose}), ColorCheck::kBeside);
  std::optional<ColorCheck::Answer> answer;
  while (!(answer = check.answer())) rest();
  EXPECT_FALSE(check.isBusy());
  EXPECT_EQ(answer->asked.position, wrong.position);
  ASSERT_TRUE(answer->found);
  EXPECT_EQ(answer->found->fit.pose.position, expected->fit.pose.position);
  EXPECT_EQ(answer->found->score(), expected->score());
}

TEST_F(ColorCheckTest, DefaultPosturesAreAddedToPoorProposalsOnly) {
  masks = person;
  EXPECT_EQ(completed(ask(pose, {pose})).proposals.size(), 1u);
  EXPECT_EQ(completed(ask(pose, {})).proposals.size(), defaultPostures(hull).size());
}

TEST_F(ColorCheckTest, AnAnswerThatIsForgottenIsNotGiven) {
  ColorCheck check;
  check.ask(ask(pose, {pose}), ColorCheck::kAwaited);
  check.forget();
  while (check.isBusy()) {
    EXPECT_FALSE(check.answer());
    rest();
  }
  check.ask(ask(pose, {pose}), ColorCheck::kAwaited);
  while (check.isBusy()) {
    if (check.answer()) return;
    rest();
  }
  FAIL() << "the next one is";
}

TEST_F(ColorCheckTest, AQuestionsCopyOutlivesTheMessages) {
  const RegionFrame frame(images, masks), copy = frame.clone();
  ASSERT_TRUE(copy.needsColors());
  const cv::Mat mask = masks[0].clone(), colors = frame.views[0].colors.clone();
  for (cv::Mat& one : masks) one.setTo(7);
  for (cv::Mat& one : images) one.setTo(7);
  EXPECT_EQ(cv::norm(copy.masks[0], mask, cv::NORM_INF), 0);
  EXPECT_EQ(cv::norm(copy.views[0].colors, colors, cv::NORM_INF), 0);
}

TEST(BroughtForward, WrongJointsAreAsFoundAndTheOthersAsTheyAreNow) {
  ContourPose asked;
  ContourPose found = asked, now = asked;
  found.angles[A::kLeftElbow] = 1.2;
  found.angles[A::kRightElbow] = 0.1;
  found.rotations[B::kLeftShoulder] = expSO3({0, -0.8, 0});
  found.position.x() += 0.05;
  now.angles[A::kRightElbow] = 0.6;
  now.angles[A::kLeftKnee] = -0.4;
  now.position = {1, 0, 1};
  const ContourPose out = broughtForward(found, asked, now);
  EXPECT_EQ(out.angles[A::kLeftElbow], 1.2);
  EXPECT_EQ(out.angles[A::kRightElbow], 0.6) << "it was nearly right, and has moved since";
  EXPECT_EQ(out.angles[A::kLeftKnee], -0.4);
  EXPECT_EQ(out.rotations[B::kLeftShoulder], found.rotations[B::kLeftShoulder]);
  EXPECT_EQ(out.position, Eigen::Vector3d(1.05, 0, 1));
}

TEST(BroughtForward, ABodyThatFacedTheOtherWayStillDoesAfterTurning) {
  ContourPose asked, found, now;
  found.rotations[B::kRoot] = expSO3({0, 0, M_PI});
  now.rotations[B::kRoot] = expSO3({0, 0, 0.5});
  const Eigen::Matrix3d expected = expSO3({0, 0, M_PI + 0.5});
  EXPECT_TRUE(broughtForward(found, asked, now).rotations[B::kRoot].isApprox(expected, 1e-9));
}

}  // namespace
}  // namespace markerless_mocap
