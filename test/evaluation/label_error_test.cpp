#include "markerless_mocap/evaluation/label_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

constexpr double kExact_mm = 1e-9;
enum { kHead, kLeftHand, kRightHand, kLeftFoot, kRightFoot };

/// Somebody who stands with the arms spread and looks along x: points and, beyond them, tips; then
/// wrists, elbows, ankles and knees.
JointTrack standing(int frames) {
  JointTrack truth;
  truth.names = labelTruthNames();
  Eigen::Matrix3Xd points(3, 18);
  points.transpose() << 0, 0, 1.6,  // head
      0, 0, 1.75,                   //
      0, 0.7, 1.4,                  // left hand
      0, 0.8, 1.4,                  //
      0, -0.7, 1.4,                 // right hand
      0, -0.8, 1.4,                 //
      0.1, 0.15, 0.05,              // left foot
      0.2, 0.15, 0.05,              //
      0.1, -0.15, 0.05,             // right foot
      0.2, -0.15, 0.05,             //
      0, 0.6, 1.4,                  // left wrist, elbow
      0, 0.4, 1.4,                  //
      0, -0.6, 1.4,                 // right wrist, elbow
      0, -0.4, 1.4,                 //
      0, 0.15, 0.08,                // left ankle, knee
      0, 0.12, 0.5,                 //
      0, -0.15, 0.08,               // right ankle, knee
      0, -0.12, 0.5;
  for (int f = 0; f < frames; ++f) truth.add(f, points);
  return truth;
}

/// Labels that are the truth.
std::vector<LabelledEnds> trueLabels(const JointTrack& truth) {
  std::vector<LabelledEnds> labels(truth.frames());
  for (size_t f = 0; f < labels.size(); ++f) {
    labels[f].valid = true;
    labels[f].validity = 1.0;
    for (int end = 0; end < kEndCount; ++end)
      labels[f].positions.col(end) = truth.positions[f].col(2 * end);
  }
  return labels;
}

void swapHands(LabelledEnds* labels) {
  labels->positions.col(kLeftHand).swap(labels->positions.col(kRightHand));
}

void swapFeet(LabelledEnds* labels) {
  labels->positions.col(kLeftFoot).swap(labels->positions.col(kRightFoot));
}

TEST(LabelErrors, TruthAgainstItselfIsRightThroughout) {
  const JointTrack truth = standing(4);
  const LabelErrors errors = labelErrors(truth, trueLabels(truth));
  EXPECT_EQ(errors.frames, 4u);
  EXPECT_EQ(errors.valid, 4u);
  EXPECT_EQ(errors.share_valid, 1.0);
  EXPECT_EQ(errors.share_right, 1.0);
  EXPECT_EQ(errors.share_right_and_valid, 1.0);
  EXPECT_EQ(errors.share_wrong_but_valid, 0.0);
  EXPECT_EQ(errors.share_sides_right, 1.0);
  EXPECT_EQ(errors.hands_mm.max, 0.0);
  EXPECT_EQ(errors.feet_mm.count, 8u);
  for (const EndError& end : errors.ends) EXPECT_EQ(end.share_right, 1.0) << end.name;
  EXPECT_EQ(errors.precision_recall_area, 1.0);
}

TEST(LabelErrors, ExchangedSidesAreWrongAndSaidToBeExchanged) {
  const JointTrack truth = standing(4);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  swapHands(&labels[0]);
  swapFeet(&labels[1]);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.share_valid, 1.0);
  EXPECT_EQ(errors.share_right, 0.5);
  EXPECT_EQ(errors.share_wrong_but_valid, 0.5);
  EXPECT_EQ(errors.share_sides_right, 0.5);
  EXPECT_EQ(errors.ends[kHead].share_right, 1.0);
  EXPECT_EQ(errors.ends[kLeftHand].share_right, 0.75);
  EXPECT_EQ(errors.ends[kRightFoot].share_right, 0.75);
  EXPECT_NEAR(errors.hands_mm.mean, 1400.0 / 4, kExact_mm);  // 1.4 m apart, in one of four frames
  EXPECT_NEAR(errors.feet_mm.mean, 300.0 / 4, kExact_mm);
  EXPECT_EQ(errors.hands_if_right_mm.max, 0.0);
  EXPECT_EQ(errors.hands_if_right_mm.count, 4u);  // of two frames
}

/// Somebody who puts the left foot close to the right of the right one.
JointTrack crossing() {
  JointTrack truth = standing(1);
  Eigen::Matrix3Xd& points = truth.positions[0];
  for (const int column : {6, 7, 14}) points(1, column) = -0.03;  // ball, toes, ankle
  for (const int column : {8, 9, 16}) points(1, column) = 0.03;
  return truth;
}

/// Labels from the truth, with legs from the balls by the ankles to the knees.
LabelledEnds labelsWithLegs(const JointTrack& truth) {
  LabelledEnds labels = trueLabels(truth)[0];
  const Eigen::Matrix3Xd& points = truth.positions[0];
  labels.limbs[kLeftFoot] = points(Eigen::all, std::vector<int>{6, 14, 15});
  labels.limbs[kRightFoot] = points(Eigen::all, std::vector<int>{8, 16, 17});
  return labels;
}

TEST(LabelErrors, FeetThatCrossAreToldApartByTheirLegs) {
  const JointTrack truth = crossing();
  LabelledEnds labels = labelsWithLegs(truth);
  // Each foot's end is found 4 cm off, beyond the other foot.
  labels.positions(1, kLeftFoot) = 0.01;
  labels.positions(1, kRightFoot) = -0.01;
  LabelErrors errors = labelErrors(truth, {labels});
  EXPECT_TRUE(errors.verdicts[0].sides_right);
  EXPECT_TRUE(errors.verdicts[0].right);
  labels.limbs = {};
  errors = labelErrors(truth, {labels});
  EXPECT_FALSE(errors.verdicts[0].sides_right) << "by the ends alone they are exchanged";
  EXPECT_TRUE(errors.verdicts[0].kinds_right);
}

TEST(LabelErrors, LegsThatAreExchangedAreFoundOutHoweverCloseTheFeetAre) {
  const JointTrack truth = crossing();
  LabelledEnds labels = labelsWithLegs(truth);
  swapFeet(&labels);
  labels.limbs[kLeftFoot].swap(labels.limbs[kRightFoot]);
  // Even where each end happens to be found at its own foot.
  const LabelledEnds legs_only = [&] {
    LabelledEnds out = labels;
    swapFeet(&out);
    return out;
  }();
  for (const LabelledEnds& wrong : {labels, legs_only}) {
    const LabelErrors errors = labelErrors(truth, {wrong});
    EXPECT_FALSE(errors.verdicts[0].sides_right);
    EXPECT_TRUE(errors.verdicts[0].kinds_right);
    EXPECT_FALSE(errors.verdicts[0].right);
    EXPECT_EQ(errors.verdicts[0].end_right,
              (std::array<bool, kEndCount>{true, true, true, false, false}));
    EXPECT_EQ(errors.share_kinds_right, 1.0);
    EXPECT_EQ(errors.share_wrong_but_valid, 1.0);
  }
}

TEST(LabelErrors, ArmsAreHeldAgainstElbowsAndWristsToo) {
  JointTrack truth = standing(1);
  Eigen::Matrix3Xd& points = truth.positions[0];
  for (const int column : {2, 3, 10}) points.col(column) << 0.4, -0.02, 1.3;  // crossed before
  for (const int column : {4, 5, 12}) points.col(column) << 0.4, 0.02, 1.3;   // the chest
  LabelledEnds labels = trueLabels(truth)[0];
  labels.limbs[kLeftHand] = points(Eigen::all, std::vector<int>{2, 10, 11});
  labels.limbs[kRightHand] = points(Eigen::all, std::vector<int>{4, 12, 13});
  labels.positions(1, kLeftHand) = 0.01;
  labels.positions(1, kRightHand) = -0.01;
  EXPECT_TRUE(labelErrors(truth, {labels}).verdicts[0].right);
  labels.limbs[kLeftHand].swap(labels.limbs[kRightHand]);
  EXPECT_FALSE(labelErrors(truth, {labels}).verdicts[0].sides_right);
}

TEST(LabelErrors, TwoLabelsOnOneFootAreWrong) {
  const JointTrack truth = standing(1);
  LabelledEnds labels = trueLabels(truth)[0];
  labels.positions.col(kRightFoot) = labels.positions.col(kLeftFoot);
  const LabelErrors errors = labelErrors(truth, {labels});
  EXPECT_FALSE(errors.verdicts[0].kinds_right);
  EXPECT_EQ(errors.verdicts[0].end_right,
            (std::array<bool, kEndCount>{true, true, true, true, false}));
}

TEST(LabelErrors, JointsThatTheTruthDoesNotHaveAreLeftOut) {
  JointTrack truth = standing(1);
  truth.positions[0].rightCols<8>().setConstant(NAN);
  LabelledEnds labels = labelsWithLegs(standing(1));
  EXPECT_TRUE(labelErrors(truth, {labels}).verdicts[0].right);
  swapFeet(&labels);
  EXPECT_FALSE(labelErrors(truth, {labels}).verdicts[0].sides_right);
}

TEST(LabelErrors, AHandOnAFootIsWrongAloneAndItsSideIsNot) {
  const JointTrack truth = standing(2);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  labels[0].positions.col(kLeftHand) = truth.positions[0].col(2 * kLeftFoot);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.share_right, 0.5);
  EXPECT_EQ(errors.share_sides_right, 1.0);
  EXPECT_EQ(errors.verdicts[0].end_right,
            (std::array<bool, kEndCount>{true, false, true, true, true}));
}

TEST(LabelErrors, AHandMayBeFarFromItsPointOrItsTipButNotFromBoth) {
  const JointTrack truth = standing(3);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  labels[0].positions.col(kLeftHand).y() = 0.7 - 0.149;  // short of the knuckles
  labels[1].positions.col(kLeftHand).y() = 0.8 + 0.149;  // beyond the tip, 249 mm from the knuckles
  labels[2].positions.col(kLeftHand).y() = 0.8 + 0.151;
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_TRUE(errors.verdicts[0].right);
  EXPECT_TRUE(errors.verdicts[1].right);
  EXPECT_FALSE(errors.verdicts[2].right);
  EXPECT_NEAR(errors.verdicts[1].error_mm[kLeftHand], 249, kExact_mm);
}

TEST(LabelErrors, TheHeadMayBeFurtherOff) {
  const JointTrack truth = standing(2);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  labels[0].positions.col(kHead).z() = 1.6 - 0.249;
  labels[1].positions.col(kHead).z() = 1.6 - 0.251;
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_TRUE(errors.verdicts[0].right);
  EXPECT_FALSE(errors.verdicts[1].right);
  EXPECT_TRUE(errors.verdicts[1].sides_right);
}

TEST(LabelErrors, InvalidFramesCostValidityAndNothingElse) {
  const JointTrack truth = standing(4);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  labels[1].valid = false;  // was right
  labels[2].valid = false;  // was wrong
  swapHands(&labels[2]);
  labels[3] = LabelledEnds();  // nothing was said
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.share_valid, 0.25);
  EXPECT_EQ(errors.share_right, 0.5);
  EXPECT_EQ(errors.share_right_and_valid, 0.25);
  EXPECT_EQ(errors.share_wrong_but_valid, 0.0);
  EXPECT_EQ(errors.share_sides_right, 1.0);
  EXPECT_EQ(errors.hands_mm.count, 2u);
  EXPECT_EQ(errors.hands_mm.max, 0.0);
}

TEST(LabelErrors, AnEndThatIsNotFoundMakesAValidFrameWrong) {
  const JointTrack truth = standing(1);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  labels[0].positions.col(kRightHand).setConstant(NAN);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_FALSE(errors.verdicts[0].complete);
  EXPECT_EQ(errors.share_wrong_but_valid, 1.0);
  EXPECT_EQ(errors.share_sides_right, 0.0);
  EXPECT_EQ(errors.ends[kLeftHand].share_right, 1.0);
  EXPECT_EQ(errors.ends[kRightHand].share_right, 0.0);
}

TEST(LabelErrors, FramesWithoutTruthAreLeftOut) {
  JointTrack truth = standing(3);
  truth.positions[1].col(3).setConstant(NAN);
  const std::vector<LabelledEnds> labels = trueLabels(truth);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.frames, 2u);
  EXPECT_EQ(errors.share_right, 1.0);
  EXPECT_FALSE(errors.verdicts[1].judged);
}

TEST(LabelErrors, PrecisionAndRecallFollowTheThreshold) {
  const JointTrack truth = standing(5);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  // By validity: right, wrong, right, right and one that was not found at all.
  const double validities[] = {0.9, 0.7, 0.5, 0.3, 1.0};
  for (int f = 0; f < 5; ++f) labels[f].validity = validities[f];
  swapHands(&labels[1]);
  labels[4].positions.setConstant(NAN);
  const LabelErrors errors = labelErrors(truth, labels);
  ASSERT_EQ(errors.by_threshold.size(), 101u);
  const auto expect = [&](int percent, double precision, double recall) {
    const ThresholdFigures& figures = errors.by_threshold[percent];
    EXPECT_NEAR(figures.threshold, percent / 100.0, 1e-12);
    EXPECT_NEAR(figures.precision, precision, 1e-12) << percent;
    EXPECT_NEAR(figures.recall, recall, 1e-12) << percent;
  };
  expect(0, 3.0 / 4, 1.0);
  expect(30, 3.0 / 4, 1.0);
  expect(31, 2.0 / 3, 2.0 / 3);
  expect(60, 1.0 / 2, 1.0 / 3);
  expect(80, 1.0, 1.0 / 3);
  EXPECT_TRUE(std::isnan(errors.by_threshold[95].precision));
  EXPECT_EQ(errors.by_threshold[95].recall, 0.0);
  EXPECT_NEAR(errors.precision_recall_area, (1.0 + 2.0 / 3 + 3.0 / 4) / 3, 1e-12);
}

TEST(LabelErrors, FramesOfOneValidityReachTheThresholdTogether) {
  const JointTrack truth = standing(4);
  std::vector<LabelledEnds> labels = trueLabels(truth);
  swapFeet(&labels[0]);
  EXPECT_NEAR(labelErrors(truth, labels).precision_recall_area, 0.75, 1e-12);
}

TEST(LabelErrors, NothingValidHasNoFigures) {
  const JointTrack truth = standing(2);
  const LabelErrors errors = labelErrors(truth, std::vector<LabelledEnds>(2));
  EXPECT_EQ(errors.share_valid, 0.0);
  EXPECT_EQ(errors.share_wrong_but_valid, 0.0);
  EXPECT_TRUE(std::isnan(errors.share_sides_right));
  EXPECT_TRUE(std::isnan(errors.hands_mm.mean));
  EXPECT_TRUE(std::isnan(errors.precision_recall_area));
}

TEST(LabelErrors, LabelsAndTruthMustHaveTheSameFrames) {
  EXPECT_THROW(labelErrors(standing(2), std::vector<LabelledEnds>(3)), std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
