#include "evaluation/label_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "evaluation/label_scene.h"

namespace markerless_mocap {
namespace {

constexpr double kExact_mm = 1e-9;

TEST(LabelErrors, TruthAgainstItselfIsRightThroughout) {
  const JointTrack truth = standing(4);
  const LabelErrors errors = labelErrors(truth, trueLabels(truth));
  EXPECT_EQ(errors.frames, 4u);
  EXPECT_EQ(errors.valid, 4u);
  EXPECT_EQ(errors.fraction_valid, 1.0);
  EXPECT_EQ(errors.fraction_correct, 1.0);
  EXPECT_EQ(errors.fraction_correct_and_valid, 1.0);
  EXPECT_EQ(errors.fraction_wrong_but_valid, 0.0);
  EXPECT_EQ(errors.fraction_sides_correct, 1.0);
  EXPECT_EQ(errors.hands_mm.max, 0.0);
  EXPECT_EQ(errors.feet_mm.count, 8u);
  for (const ExtremityLabelError& end : errors.ends)
    EXPECT_EQ(end.fraction_correct, 1.0) << end.name;
  EXPECT_EQ(errors.precision_recall_area, 1.0);
}

TEST(LabelErrors, ExchangedSidesAreWrongAndSaidToBeExchanged) {
  const JointTrack truth = standing(4);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  swapHands(&labels[0]);
  swapFeet(&labels[1]);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.fraction_valid, 1.0);
  EXPECT_EQ(errors.fraction_correct, 0.5);
  EXPECT_EQ(errors.fraction_wrong_but_valid, 0.5);
  EXPECT_EQ(errors.fraction_sides_correct, 0.5);
  EXPECT_EQ(errors.ends[kHead].fraction_correct, 1.0);
  EXPECT_EQ(errors.ends[kLeftHand].fraction_correct, 0.75);
  EXPECT_EQ(errors.ends[kRightFoot].fraction_correct, 0.75);
  EXPECT_NEAR(errors.hands_mm.mean, 1400.0 / 4, kExact_mm);  // 1.4 m apart, in one of four frames
  EXPECT_NEAR(errors.feet_mm.mean, 300.0 / 4, kExact_mm);
  EXPECT_EQ(errors.hands_if_correct_mm.max, 0.0);
  EXPECT_EQ(errors.hands_if_correct_mm.count, 4u);  // of two frames
}

TEST(LabelErrors, AHandOnAFootIsWrongAloneAndItsSideIsNot) {
  const JointTrack truth = standing(2);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  labels[0].positions.col(kLeftHand) = truth.positions[0].col(2 * kLeftFoot);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.fraction_correct, 0.5);
  EXPECT_EQ(errors.fraction_sides_correct, 1.0);
  EXPECT_EQ(errors.verdicts[0].extremity_correct,
            (std::array<bool, kLabelledExtremityCount>{true, false, true, true, true}));
}

TEST(LabelErrors, AHandMayBeFarFromItsPointOrItsTipButNotFromBoth) {
  const JointTrack truth = standing(3);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
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
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  labels[0].positions.col(kHead).z() = 1.6 - 0.249;
  labels[1].positions.col(kHead).z() = 1.6 - 0.251;
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_TRUE(errors.verdicts[0].right);
  EXPECT_FALSE(errors.verdicts[1].right);
  EXPECT_TRUE(errors.verdicts[1].sides_correct);
}

TEST(LabelErrors, InvalidFramesCostValidityAndNothingElse) {
  const JointTrack truth = standing(4);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  labels[1].valid = false;  // was right
  labels[2].valid = false;  // was wrong
  swapHands(&labels[2]);
  labels[3] = LabelledExtremities();  // nothing was said
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.fraction_valid, 0.25);
  EXPECT_EQ(errors.fraction_correct, 0.5);
  EXPECT_EQ(errors.fraction_correct_and_valid, 0.25);
  EXPECT_EQ(errors.fraction_wrong_but_valid, 0.0);
  EXPECT_EQ(errors.fraction_sides_correct, 1.0);
  EXPECT_EQ(errors.hands_mm.count, 2u);
  EXPECT_EQ(errors.hands_mm.max, 0.0);
}

TEST(LabelErrors, AnEndThatIsNotFoundMakesAValidFrameWrong) {
  const JointTrack truth = standing(1);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  labels[0].positions.col(kRightHand).setConstant(NAN);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_FALSE(errors.verdicts[0].complete);
  EXPECT_EQ(errors.fraction_wrong_but_valid, 1.0);
  EXPECT_EQ(errors.fraction_sides_correct, 0.0);
  EXPECT_EQ(errors.ends[kLeftHand].fraction_correct, 1.0);
  EXPECT_EQ(errors.ends[kRightHand].fraction_correct, 0.0);
}

TEST(LabelErrors, FramesWithoutTruthAreLeftOut) {
  JointTrack truth = standing(3);
  truth.positions[1].col(3).setConstant(NAN);
  const std::vector<LabelledExtremities> labels = trueLabels(truth);
  const LabelErrors errors = labelErrors(truth, labels);
  EXPECT_EQ(errors.frames, 2u);
  EXPECT_EQ(errors.fraction_correct, 1.0);
  EXPECT_FALSE(errors.verdicts[1].evaluated);
}

TEST(LabelErrors, PrecisionAndRecallFollowTheThreshold) {
  const JointTrack truth = standing(5);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  // By validity: right, wrong, right, right and one that was not found at all.
  const double validities[] = {0.9, 0.7, 0.5, 0.3, 1.0};
  for (int f = 0; f < 5; ++f) labels[f].validity = validities[f];
  swapHands(&labels[1]);
  labels[4].positions.setConstant(NAN);
  const LabelErrors errors = labelErrors(truth, labels);
  ASSERT_EQ(errors.by_threshold.size(), 101u);
  const auto expect = [&](int percent, double precision, double recall) {
    const PrecisionRecallPoint& figures = errors.by_threshold[percent];
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
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  swapFeet(&labels[0]);
  EXPECT_NEAR(labelErrors(truth, labels).precision_recall_area, 0.75, 1e-12);
}

TEST(LabelErrors, ReliabilityHoldsValidityAgainstWhatIsRight) {
  const JointTrack truth = standing(6);
  std::vector<LabelledExtremities> labels = trueLabels(truth);
  const double validities[] = {0.91, 0.95, 1.0, 0.02, 0.04, 0.5};
  for (int f = 0; f < 6; ++f) labels[f].validity = validities[f];
  swapHands(&labels[1]);
  swapHands(&labels[3]);
  labels[5].positions.setConstant(NAN);
  const std::vector<ReliabilityBin> bins = labelErrors(truth, labels).reliability;
  ASSERT_EQ(bins.size(), 2u);
  EXPECT_EQ(bins[0].frames, 2u);
  EXPECT_NEAR(bins[0].mean_validity, 0.03, 1e-12);
  EXPECT_NEAR(bins[0].fraction_correct, 0.5, 1e-12);
  EXPECT_EQ(bins[1].frames, 3u);
  EXPECT_NEAR(bins[1].fraction_correct, 2.0 / 3, 1e-12);
}

TEST(LabelErrors, NothingValidHasNoFigures) {
  const JointTrack truth = standing(2);
  const LabelErrors errors = labelErrors(truth, std::vector<LabelledExtremities>(2));
  EXPECT_EQ(errors.fraction_valid, 0.0);
  EXPECT_EQ(errors.fraction_wrong_but_valid, 0.0);
  EXPECT_TRUE(std::isnan(errors.fraction_sides_correct));
  EXPECT_TRUE(std::isnan(errors.hands_mm.mean));
  EXPECT_TRUE(std::isnan(errors.precision_recall_area));
}

TEST(LabelErrors, LabelsAndTruthMustHaveTheSameFrames) {
  EXPECT_THROW(labelErrors(standing(2), std::vector<LabelledExtremities>(3)),
               std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
