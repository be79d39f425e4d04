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
LabelledEnds labelsWithLegs(const JointTrack& truth) {
  LabelledEnds labels = trueLabels(truth)[0];
  const Eigen::Matrix3Xd& points = truth.positions[0];
  labels.limbs[kLeftFoot] = points(Eigen::all, std::vector<int>{6, 14, 15});
  labels.limbs[kRightFoot] = points(Eigen::all, std::vector<int>{8, 16, 17});
  return labels;
}

TEST(LabelSides, FeetThatCrossAreToldApartByTheirLegs) {
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

TEST(LabelSides, LegsThatAreExchangedAreFoundOutHoweverCloseTheFeetAre) {
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

TEST(LabelSides, ArmsAreHeldAgainstElbowsAndWristsToo) {
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

TEST(LabelSides, TwoLabelsOnOneFootAreWrong) {
  const JointTrack truth = standing(1);
  LabelledEnds labels = trueLabels(truth)[0];
  labels.positions.col(kRightFoot) = labels.positions.col(kLeftFoot);
  const LabelErrors errors = labelErrors(truth, {labels});
  EXPECT_FALSE(errors.verdicts[0].kinds_right);
  EXPECT_EQ(errors.verdicts[0].end_right,
            (std::array<bool, kEndCount>{true, true, true, true, false}));
}

TEST(LabelSides, JointsThatTheTruthDoesNotHaveAreLeftOut) {
  JointTrack truth = standing(1);
  truth.positions[0].rightCols<8>().setConstant(NAN);
  LabelledEnds labels = labelsWithLegs(standing(1));
  EXPECT_TRUE(labelErrors(truth, {labels}).verdicts[0].right);
  swapFeet(&labels);
  EXPECT_FALSE(labelErrors(truth, {labels}).verdicts[0].sides_right);
}

}  // namespace
}  // namespace markerless_mocap
