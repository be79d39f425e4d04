#include "contour/track/pose_from_pose_tree.h"

#include <gtest/gtest.h>

#include <cmath>

#include "contour/drawn_body.h"

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using J = TreeJoint;

void put(PoseTree& tree, TreeJoint joint, const Vector3d& at) {
  tree.joints[size_t(joint)] = at;
}

/// Hips' middle at (1, 2, 0.9), upright, looking along world y: left is -x.
PoseTree trunk() {
  PoseTree tree;
  put(tree, J::kLeftHip, {0.9, 2, 0.9});
  put(tree, J::kRightHip, {1.1, 2, 0.9});
  put(tree, J::kNeck, {1, 2, 1.4});
  return tree;
}

/// An arm that hangs and whose forearm points forward, world y.
void bendLeftArm(PoseTree& tree) {
  put(tree, J::kLeftShoulder, {0.8, 2, 1.4});
  put(tree, J::kLeftElbow, {0.8, 2, 1.1});
  put(tree, J::kLeftWrist, {0.8, 2.25, 1.1});
}

double angleBetween(const Matrix3d& one, const Matrix3d& other) {
  return logSO3(one.transpose() * other).norm();
}

TEST(PoseOfTree, TheTrunkStandsOnTheHipsAndLooksAcrossThem) {
  const auto pose = poseFromPoseTree(trunk());
  ASSERT_TRUE(pose);
  EXPECT_LT((pose->position - Vector3d(1, 2, 0.9)).norm(), 1e-12);
  Matrix3d expected;  // columns: front, left, up
  expected << Vector3d::UnitY(), -Vector3d::UnitX(), Vector3d::UnitZ();
  EXPECT_LT(angleBetween(pose->rotations[B::kRoot], expected), 1e-6);
}

TEST(PoseOfTree, LimbsWithoutJointsHangDown) {
  PoseTree tree = trunk();
  put(tree, J::kLeftShoulder, {0.8, 2, 1.4});  // an arm of two joints says nothing
  put(tree, J::kLeftElbow, {0.5, 2, 1.4});
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  for (size_t ball = B::kNeck; ball < B::kCount; ++ball)
    EXPECT_EQ(pose->rotations[ball], Matrix3d::Identity()) << ball;
  for (const double angle : pose->angles) EXPECT_EQ(angle, 0.0);
}

TEST(PoseOfTree, NeedsBothHipsAndTheNeck) {
  for (const TreeJoint joint : {J::kLeftHip, J::kRightHip, J::kNeck}) {
    PoseTree tree = trunk();
    tree.joints[size_t(joint)].reset();
    EXPECT_FALSE(poseFromPoseTree(tree)) << toString(joint);
  }
  EXPECT_FALSE(poseFromPoseTree(PoseTree{}));
}

TEST(PoseOfTree, JointsInOnePlaceTellNoFrame) {
  PoseTree tree = trunk();
  put(tree, J::kRightHip, {0.9, 2, 0.9});
  EXPECT_FALSE(poseFromPoseTree(tree)) << "hips";
  tree = trunk();
  put(tree, J::kNeck, {1.5, 2, 0.9});
  EXPECT_FALSE(poseFromPoseTree(tree)) << "neck in line with the hips";
  tree = trunk();
  bendLeftArm(tree);
  put(tree, J::kLeftElbow, {0.8, 2, 1.4});
  ASSERT_TRUE(poseFromPoseTree(tree));
  EXPECT_EQ(poseFromPoseTree(tree)->rotations[B::kLeftShoulder], Matrix3d::Identity())
      << "elbow on shoulder";
}

TEST(PoseOfTree, AForearmForwardIsARightAngleOfTheElbow) {
  PoseTree tree = trunk();
  bendLeftArm(tree);
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->angles[A::kLeftElbow], M_PI / 2, 1e-9);
  EXPECT_LT(angleBetween(pose->rotations[B::kLeftShoulder], Matrix3d::Identity()), 1e-6);
  EXPECT_EQ(pose->angles[A::kRightElbow], 0.0);
}

TEST(PoseOfTree, AnArmTurnsSoThatTheForearmIsWhereItBends) {
  PoseTree tree = trunk();
  put(tree, J::kRightShoulder, {1.2, 2, 1.4});
  put(tree, J::kRightElbow, {1.5, 2, 1.4});  // out to the right, world x
  put(tree, J::kRightWrist, {1.5, 2, 1.7});  // and up
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->angles[A::kRightElbow], M_PI / 2, 1e-9);
  const Matrix3d upper = pose->rotations[B::kRoot] * pose->rotations[B::kRightShoulder];
  EXPECT_LT((upper * -Vector3d::UnitZ() - Vector3d::UnitX()).norm(), 1e-9) << "along the bone";
  EXPECT_LT((upper * Vector3d::UnitX() - Vector3d::UnitZ()).norm(), 1e-9) << "front: bends there";
  EXPECT_NEAR(upper.determinant(), 1.0, 1e-9);
}

TEST(PoseOfTree, AKneeBendsBackwardAndItsAngleIsNegative) {
  PoseTree tree = trunk();
  put(tree, J::kLeftKnee, {0.9, 2, 0.5});
  put(tree, J::kLeftAnkle, {0.9, 2 - 0.4 * std::sin(0.6), 0.5 - 0.4 * std::cos(0.6)});
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->angles[A::kLeftKnee], -0.6, 1e-9);
  EXPECT_LT(angleBetween(pose->rotations[B::kLeftHip], Matrix3d::Identity()), 1e-6);
}

TEST(PoseOfTree, AStraightLimbFacesWhereTheTrunkDoes) {
  PoseTree tree = trunk();
  put(tree, J::kLeftKnee, {0.9, 2, 0.5});
  put(tree, J::kLeftAnkle, {0.9, 2, 0.1});
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  EXPECT_NEAR(pose->angles[A::kLeftKnee], 0.0, 1e-9);
  EXPECT_LT(angleBetween(pose->rotations[B::kLeftHip], Matrix3d::Identity()), 1e-6);
}

TEST(PoseOfTree, LimbsOfABodyInStrideComeOutWhereTheyAre) {
  const ContourBody body(ShapeStatistics::handMade().meanShape(1.75));
  ContourPose truth = stride();
  truth.angles[A::kSpinePitch] = truth.angles[A::kSpineTwist] = 0;  // a tree tells of none
  const Eigen::Matrix3Xd points = body.points(truth);
  // From the order of contourPointNames().
  constexpr int kPoints[kTreeJointCount] = {1, 3, 6, 4, 7, 5, 8, 9, 12, 10, 13, 11, 14};
  PoseTree tree;
  for (size_t joint = 0; joint < kTreeJointCount; ++joint)
    put(tree, TreeJoint(joint), points.col(kPoints[joint]));
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  EXPECT_LT((body.points(*pose) - points).leftCols<15>().rightCols<12>().norm(), 1e-6);
  for (const size_t angle : {A::kLeftElbow, A::kRightElbow, A::kLeftKnee, A::kRightKnee})
    EXPECT_NEAR(pose->angles[angle], truth.angles[angle], 1e-9);
}

TEST(PoseOfTree, ProposesNothingFromJointsThatAreNotFinite) {
  PoseTree tree = trunk();
  put(tree, J::kNeck, {NAN, 2, 1.4});
  EXPECT_FALSE(poseFromPoseTree(tree));
  tree = trunk();
  bendLeftArm(tree);
  put(tree, J::kLeftWrist, {0.8, NAN, 1.1});
  const auto pose = poseFromPoseTree(tree);
  ASSERT_TRUE(pose);
  EXPECT_EQ(pose->rotations[B::kLeftShoulder], Matrix3d::Identity());
}

}  // namespace
}  // namespace markerless_mocap
