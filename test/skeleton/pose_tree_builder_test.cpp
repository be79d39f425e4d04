#include "markerless_mocap/skeleton/pose_tree_builder.h"

#include <gtest/gtest.h>

#include <cmath>

#include "error_text_of.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

constexpr double kFine = 0.0156, kCoarse = 0.031;

PoseTree treeOf(const VisualHull& hull, const PoseTreeOptions& options = {}) {
  return PoseTreeBuilder(options).build(hull);
}

const Eigen::Vector3d& tipOf(const PoseTree& tree, Extremity extremity) {
  return tree.extremity(extremity).position;
}

void expectExtremities(const PoseTree& tree, const FigurePose& pose, double tolerance) {
  EXPECT_LT((tipOf(tree, Extremity::kLeftHand) - pose.left_hand).norm(), tolerance);
  EXPECT_LT((tipOf(tree, Extremity::kRightHand) - pose.right_hand).norm(), tolerance);
  const Eigen::Vector3d ball(0.12, 0.0, -0.06);
  EXPECT_LT((tipOf(tree, Extremity::kLeftFoot) - pose.left_ankle - ball).norm(), tolerance);
  EXPECT_LT((tipOf(tree, Extremity::kRightFoot) - pose.right_ankle - ball).norm(), tolerance);
  EXPECT_LT((tipOf(tree, Extremity::kHead) - Eigen::Vector3d(0.02, 0.0, 1.62)).norm(), tolerance);
}

FigurePose walking(double phase) {
  FigurePose pose;
  const double swing = 0.25 * std::sin(phase);
  pose.left_elbow = {-0.6 * swing, 0.42, 1.15};
  pose.left_hand = {-swing + 0.1, 0.48, 0.92};
  pose.right_elbow = {0.6 * swing, -0.42, 1.15};
  pose.right_hand = {swing + 0.1, -0.48, 0.92};
  pose.left_knee = {0.6 * swing + 0.07, 0.13, 0.5};
  pose.left_ankle = {swing - 0.05, 0.13, 0.12};
  pose.right_knee = {-0.6 * swing + 0.07, -0.13, 0.5};
  pose.right_ankle = {-swing - 0.05, -0.13, 0.12};
  return pose;
}

TEST(PoseTree, StandingPersonIsLabelledAtBothPitches) {
  for (const double pitch : {kFine, kCoarse}) {
    const FigurePose pose;
    const PoseTree tree = treeOf(personHull(pose, pitch));
    ASSERT_EQ(tree.status, TreeStatus::kOk) << tree.reason;
    EXPECT_TRUE(tree.reason.empty());
    expectExtremities(tree, pose, pitch == kFine ? 0.08 : 0.12);
    EXPECT_GT(tree.forward.x(), 0.8);
    EXPECT_GT(tree.left.y(), 0.8);
    EXPECT_GT(tree.validity, 0.8);
    EXPECT_GT(tree.rank, 0.0);
  }
}

TEST(PoseTree, NodesFormATreeFromTheHeadWithAllParts) {
  const PoseTree tree = treeOf(personHull(FigurePose(), kFine));
  std::array<int, kTreePartCount> counts{};
  for (size_t node = 0; node < tree.nodes.size(); ++node) {
    EXPECT_LT(tree.nodes[node].parent, int32_t(node));
    ++counts[size_t(tree.nodes[node].part)];
  }
  for (size_t part = 1; part < counts.size(); ++part) EXPECT_GT(counts[part], 5) << part;
  EXPECT_EQ(tree.nodes[0].parent, -1);
  EXPECT_EQ(tree.extremity(Extremity::kHead).node, 0);
  const auto partAt = [&](Extremity e) { return tree.nodes[size_t(tree.extremity(e).node)].part; };
  EXPECT_EQ(partAt(Extremity::kLeftHand), TreePart::kLeftArm);
  EXPECT_EQ(partAt(Extremity::kRightFoot), TreePart::kRightLeg);
  EXPECT_FALSE(tree.skeleton.voxels.empty());
}

TEST(PoseTree, MirroredPersonGetsMirroredLabels) {
  FigurePose pose;
  pose.left_hand = {0.3, 0.5, 1.6};
  pose.left_knee = {0.22, 0.15, 0.55};
  const FigurePose other = mirrored(pose);
  expectExtremities(treeOf(personHull(pose, kFine)), pose, 0.09);
  expectExtremities(treeOf(personHull(other, kFine)), other, 0.09);
}

TEST(PoseTree, JointsLieWhereTheFigureHasThem) {
  const FigurePose pose;
  const PoseTree tree = treeOf(personHull(pose, kFine));
  const auto expectNear = [&](TreeJoint joint, const Eigen::Vector3d& at) {
    ASSERT_TRUE(tree.joint(joint).has_value()) << toString(joint);
    EXPECT_LT((*tree.joint(joint) - at).norm(), 0.11) << toString(joint);
  };
  expectNear(TreeJoint::kLeftKnee, pose.left_knee);
  expectNear(TreeJoint::kRightKnee, pose.right_knee);
  expectNear(TreeJoint::kLeftShoulder, {0, 0.19, 1.39});
  expectNear(TreeJoint::kRightShoulder, {0, -0.19, 1.39});
  expectNear(TreeJoint::kLeftHip, {0, 0.1, 0.92});
  expectNear(TreeJoint::kRightHip, {0, -0.1, 0.92});
  EXPECT_TRUE(tree.joint(TreeJoint::kNeck).has_value());
}

TEST(PoseTree, WalkIsLabelledOrRefusedButNeverWrong) {
  int valid = 0;
  for (int step = 0; step < 12; ++step) {
    const FigurePose pose = walking(step * 0.52);
    const PoseTree tree = treeOf(personHull(pose, kFine));
    if (!tree.valid()) {
      EXPECT_FALSE(tree.reason.empty());
      continue;
    }
    ++valid;
    expectExtremities(tree, pose, 0.15);
  }
  EXPECT_GE(valid, 8);
}

TEST(PoseTree, HandOnTheHipClosesALoopAndIsSurvived) {
  FigurePose pose;
  pose.left_elbow = {0.0, 0.45, 1.15};
  pose.left_hand = {0.05, 0.19, 0.97};
  const PoseTree tree = treeOf(personHull(pose, kFine));
  if (tree.valid()) expectExtremities(tree, pose, 0.2);
  EXPECT_GE(tree.extremity(Extremity::kRightHand).node, 0);
}

TEST(PoseTree, PublishedLabellingStaysSelectable) {
  PoseTreeOptions options;
  options.labelling = "ranking";
  options.side_rule = "angles";
  const FigurePose pose;
  const PoseTree tree = treeOf(personHull(pose, kFine), options);
  ASSERT_EQ(tree.status, TreeStatus::kOk) << tree.reason;
  expectExtremities(tree, pose, 0.09);
  EXPECT_GT(tree.rank, 0.01);
  options.min_rank = 1.0;
  EXPECT_EQ(treeOf(personHull(pose, kFine), options).status, TreeStatus::kLowRank);
}

TEST(PoseTree, FramesStandAloneUnlessLabelsAreFollowed) {
  PoseTreeOptions options;
  PoseTreeBuilder builder(options);
  const VisualHull a = personHull(FigurePose(), kCoarse), b = personHull(walking(1.0), kCoarse);
  const PoseTree first = builder.build(a);
  builder.build(b);
  const PoseTree again = builder.build(a);
  EXPECT_EQ(first.validity, again.validity);
  for (size_t i = 0; i < first.extremities.size(); ++i)
    EXPECT_EQ(first.extremities[i].node, again.extremities[i].node);
  options.labelling = "ranking";
  options.follow_labels = true;
  PoseTreeBuilder following(options);
  EXPECT_TRUE(following.build(a).valid());
  EXPECT_TRUE(following.build(a).valid());
  following.reset();
  EXPECT_TRUE(following.build(a).valid());
}

TEST(PoseTree, WhatIsNoPersonIsRefusedWithAReason) {
  const auto rejected = [](const VisualHull& hull, TreeStatus status, const std::string& part) {
    const PoseTree tree = treeOf(hull);
    EXPECT_EQ(tree.status, status) << tree.reason;
    EXPECT_NE(tree.reason.find(part), std::string::npos) << tree.reason;
    EXPECT_FALSE(tree.valid());
  };
  rejected(VisualHull(), TreeStatus::kNoSkeleton, "empty");
  TreeFigure voxel(kCoarse);
  rejected(voxel.line({0, 0, 1}, {0, 0, 1}).hull(), TreeStatus::kNoSkeleton, "litres");
  TreeFigure block(kCoarse);
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      block.line({-0.5 + 0.03 * i, -0.5 + 0.03 * j, 0.1}, {-0.5 + 0.03 * i, -0.5 + 0.03 * j, 1.0});
  rejected(block.hull(), TreeStatus::kNotAPerson, "litres");
  VisualHull crowd;
  crowd.status = HullStatus::kSeveralBodies;
  rejected(crowd, TreeStatus::kNotAPerson, "several bodies");
}

TEST(PoseTree, BallAndPillarOfAPersonsSizeAreRefused) {
  TreeFigure ball(kCoarse);
  const PoseTree round = treeOf(ball.capsule({0, 0, 1}, {0, 0, 1}, 0.25).hull());
  EXPECT_FALSE(round.valid());
  EXPECT_FALSE(round.reason.empty());
  TreeFigure pillar(kCoarse);
  const PoseTree upright = treeOf(pillar.capsule({0, 0, 0.2}, {0, 0, 1.6}, 0.13).hull());
  EXPECT_FALSE(upright.valid());
  EXPECT_FALSE(upright.reason.empty());
}

TEST(PoseTree, TwoPeopleAreNotOne) {
  TreeFigure apart(kCoarse);
  addPerson(FigurePose(), {-0.5, -0.2, 0}, &apart);
  addPerson(FigurePose(), {0.8, 0.3, 0}, &apart);
  const PoseTree two = treeOf(apart.hull());
  EXPECT_EQ(two.status, TreeStatus::kNotAPerson) << two.reason;
  TreeFigure touching(kCoarse);
  FigurePose narrow;
  narrow.left_hand = {0.1, 0.55, 1.1};
  addPerson(narrow, {0, -0.5, 0}, &touching);
  addPerson(mirrored(narrow), {0, 0.55, 0}, &touching);
  EXPECT_FALSE(treeOf(touching.hull()).valid());
}

TEST(PoseTree, SkeletonOfSomebodyElseIsTaken) {
  TreeFigure line(kCoarse);
  line.line({0, 0, 0.2}, {0, 0, 1.6});
  PoseTreeBuilder builder{PoseTreeOptions()};
  const PoseTree tree = builder.build(personHull(FigurePose(), kCoarse), line.skeleton());
  EXPECT_EQ(tree.status, TreeStatus::kTooFewBranches) << tree.reason;
}

TEST(PoseTree, OptionsOutOfRangeAreNamed) {
  PoseTreeOptions options;
  options.prune_ratio = 0.9;
  EXPECT_NE(errorTextOf([&] { PoseTreeBuilder builder(options); }).find("prune_ratio"),
            std::string::npos);
  options = {};
  options.labelling = "guess";
  EXPECT_THROW(PoseTreeBuilder builder(options), std::invalid_argument);
}

TEST(PoseTree, EveryNameHasAText) {
  EXPECT_STREQ(toString(TreePart::kRightLeg), "right_leg");
  EXPECT_STREQ(toString(Extremity::kRightFoot), "right_foot");
  EXPECT_STREQ(toString(TreeJoint::kRightAnkle), "r_ankle");
  EXPECT_STREQ(toString(TreeStatus::kUncertain), "uncertain");
}

}  // namespace
}  // namespace markerless_mocap
