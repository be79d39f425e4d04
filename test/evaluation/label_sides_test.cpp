#include <gtest/gtest.h>

#include "evaluation/label_scene.h"

namespace markerless_mocap {
namespace {

/// Somebody who puts the left foot close to the right of the right one.
JointTrack crossing() {
  JointTrack truth = standing(1);
  Eigen::Matrix3Xd& points = truth.positions[0];
  for (const int column : {6, 7, 14}) points(1, column) = -0.03;  // ball, toes, ankle
  for (const int column : {8, 9, 16}) points(1, column) = 0.03;
  return truth;
}

/// Labels from the truth, with legs from the balls by the ankles to the knees.
LabelledExtremities labelsWithLegs(const JointTrack& truth) {
  LabelledExtremities labels = trueLabels(truth)[0];
  const Eigen::Matrix3Xd& points = truth.positions[0];
  labels.limbs[kLeftFoot] = points(Eigen::all, std::vector<int>{6, 14, 15});
  labels.limbs[kRightFoot] = points(Eigen::all, std::vector<int>{8, 16, 17});
  return labels;
}

TEST(LabelSides, FeetThatCrossAreToldApartByTheirLegs) {
  const JointTrack truth = crossing();
  LabelledExtremities labels = labelsWithLegs(truth);
  // Each foot's end is found 4 cm off, beyond the other foot.
  labels.positions(1, kLeftFoot) = 0.01;
  labels.positions(1, kRightFoot) = -0.01;
  LabelErrors errors = labelErrors(truth, {labels});
  EXPECT_TRUE(errors.verdicts[0].sides_correct);
  EXPECT_TRUE(errors.verdicts[0].right);
  labels.limbs = {};
  errors = labelErrors(truth, {labels});
  EXPECT_FALSE(errors.verdicts[0].sides_correct) << "by the ends alone they are exchanged";
  EXPECT_TRUE(errors.verdicts[0].kinds_correct);
}

TEST(LabelSides, LegsThatAreExchangedAreFoundOutHoweverCloseTheFeetAre) {
  const JointTrack truth = crossing();
  LabelledExtremities labels = labelsWithLegs(truth);
  swapFeet(&labels);
  labels.limbs[kLeftFoot].swap(labels.limbs[kRightFoot]);
  // Even where each end happens to be found at its own foot.
  const LabelledExtremities legs_only = [&] {
    LabelledExtremities out = labels;
    swapFeet(&out);
    return out;
  }();
  for (const LabelledExtremities& wrong : {labels, legs_only}) {
    const LabelErrors errors = labelErrors(truth, {wrong});
    EXPECT_FALSE(errors.verdicts[0].sides_correct);
    EXPECT_TRUE(errors.verdicts[0].kinds_correct);
    EXPECT_FALSE(errors.verdicts[0].right);
    EXPECT_EQ(errors.verdicts[0].extremity_correct,
              (std::array<bool, kLabelledExtremityCount>{true, true, true, false, false}));
    EXPECT_EQ(errors.fraction_kinds_correct, 1.0);
    EXPECT_EQ(errors.fraction_wrong_but_valid, 1.0);
  }
}

TEST(LabelSides, ArmsAreHeldAgainstElbowsAndWristsToo) {
  JointTrack truth = standing(1);
  Eigen::Matrix3Xd& points = truth.positions[0];
  for (const int column : {2, 3, 10}) points.col(column) << 0.4, -0.02, 1.3;  // crossed before
  for (const int column : {4, 5, 12}) points.col(column) << 0.4, 0.02, 1.3;   // the chest
  LabelledExtremities labels = trueLabels(truth)[0];
  labels.limbs[kLeftHand] = points(Eigen::all, std::vector<int>{2, 10, 11});
  labels.limbs[kRightHand] = points(Eigen::all, std::vector<int>{4, 12, 13});
  labels.positions(1, kLeftHand) = 0.01;
  labels.positions(1, kRightHand) = -0.01;
  EXPECT_TRUE(labelErrors(truth, {labels}).verdicts[0].right);
  labels.limbs[kLeftHand].swap(labels.limbs[kRightHand]);
  EXPECT_FALSE(labelErrors(truth, {labels}).verdicts[0].sides_correct);
}

TEST(LabelSides, TwoLabelsOnOneFootAreWrong) {
  const JointTrack truth = standing(1);
  LabelledExtremities labels = trueLabels(truth)[0];
  labels.positions.col(kRightFoot) = labels.positions.col(kLeftFoot);
  const LabelErrors errors = labelErrors(truth, {labels});
  EXPECT_FALSE(errors.verdicts[0].kinds_correct);
  EXPECT_EQ(errors.verdicts[0].extremity_correct,
            (std::array<bool, kLabelledExtremityCount>{true, true, true, true, false}));
}

TEST(LabelSides, JointsThatTheTruthDoesNotHaveAreLeftOut) {
  JointTrack truth = standing(1);
  truth.positions[0].rightCols<8>().setConstant(NAN);
  LabelledExtremities labels = labelsWithLegs(standing(1));
  EXPECT_TRUE(labelErrors(truth, {labels}).verdicts[0].right);
  swapFeet(&labels);
  EXPECT_FALSE(labelErrors(truth, {labels}).verdicts[0].sides_correct);
}

}  // namespace
}  // namespace markerless_mocap
