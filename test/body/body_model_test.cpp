#include "markerless_mocap/body/body_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

class HumanTest : public ::testing::Test {
 protected:
  Eigen::Isometry3d frame(const std::string& link) {
    LinkPoses poses;
    model_.forwardKinematics(T_world_root_, angles_, poses);
    return poses[model_.linkIndex(link)];
  }
  Eigen::Vector3d origin(const std::string& link) { return frame(link).translation(); }
  void set(const std::string& joint, double angle) { angles_[model_.angleIndex(joint)] = angle; }

  const BodyModel model_ = human();
  const BodyProportions lengths_ = BodyProportions::fromStature(1.75);
  Eigen::Isometry3d T_world_root_ = Eigen::Isometry3d::Identity();
  Eigen::VectorXd angles_ = Eigen::VectorXd::Zero(model_.angleCount());
};

TEST_F(HumanTest, zeroPoseStandsWithHangingArms) {
  const double half_shoulders = lengths_.shoulder_width / 2, half_hips = lengths_.hip_width / 2;
  EXPECT_TRUE(origin("torso").isApprox(Eigen::Vector3d(0, 0, lengths_.torso), 1e-5));
  EXPECT_TRUE(
      origin("l_shoulder").isApprox(Eigen::Vector3d(0, half_shoulders, lengths_.torso), 1e-5));
  EXPECT_TRUE(origin("r_wrist").isApprox(
      Eigen::Vector3d(0, -half_shoulders, lengths_.torso - lengths_.upper_arm - lengths_.forearm),
      1e-5));
  EXPECT_TRUE(origin("l_ankle").isApprox(
      Eigen::Vector3d(0, half_hips, -lengths_.thigh - lengths_.shank), 1e-5));
}

TEST_F(HumanTest, leftArmRaisedSidewaysPointsLeft) {
  set("l_p_shoulder", M_PI / 2);
  const Eigen::Vector3d hand(0, lengths_.shoulder_width / 2 + lengths_.upper_arm + lengths_.forearm,
                             lengths_.torso);
  EXPECT_TRUE(origin("l_wrist").isApprox(hand, 1e-5)) << origin("l_wrist").transpose();
}

TEST_F(HumanTest, shoulderYawBringsTheRaisedArmForward) {
  for (const char* side : {"l", "r"}) {
    set(std::string(side) + "_p_shoulder", M_PI / 2);
    set(std::string(side) + "_y_shoulder", M_PI / 2);
    const Eigen::Vector3d arm =
        origin(std::string(side) + "_wrist") - origin(std::string(side) + "_shoulder");
    EXPECT_NEAR(arm.x(), lengths_.upper_arm + lengths_.forearm, 1e-5);
  }
}

TEST_F(HumanTest, elbowOfTheHangingArmBendsForward) {
  set("r_elbow", M_PI / 2);
  const Eigen::Vector3d forearm = origin("r_wrist") - origin("r_elbow");
  EXPECT_TRUE(forearm.isApprox(Eigen::Vector3d(lengths_.forearm, 0, 0), 1e-5));
}

TEST_F(HumanTest, sittingLiftsTheThighForwardAndTheShankHangs) {
  set("l_r_hip", M_PI / 2);
  set("l_knee", -M_PI / 2);
  const Eigen::Vector3d knee(lengths_.thigh, lengths_.hip_width / 2, 0);
  EXPECT_TRUE(origin("l_knee").isApprox(knee, 1e-5));
  EXPECT_TRUE(origin("l_ankle").isApprox(knee - Eigen::Vector3d(0, 0, lengths_.shank), 1e-5));
}

TEST_F(HumanTest, kneeBendTakesTheAnkleBackwards) {
  set("r_knee", -1.0);
  EXPECT_NEAR(origin("r_ankle").x(), -lengths_.shank * std::sin(1.0), 1e-5);
}

TEST_F(HumanTest, spineBendsForwardAndSideways) {
  set("waist", 0.5);
  EXPECT_NEAR(origin("torso").x(), 0.7 * lengths_.torso * std::sin(0.5), 1e-5);
  set("waist", 0.0);
  set("r_waist", 0.5);
  EXPECT_NEAR(origin("torso").y(), -0.7 * lengths_.torso * std::sin(0.5), 1e-5);
}

TEST_F(HumanTest, ankleLiftsTheToes) {
  const Eigen::Vector3d before = origin("l_ankle");
  set("l_ankle", 0.3);
  EXPECT_NEAR(frame("l_ankle").linear().col(0).z(), std::sin(0.3), 1e-9);
  EXPECT_TRUE(origin("l_ankle").isApprox(before, 1e-12));
}

TEST_F(HumanTest, mirroredAnglesGiveAMirroredBody) {
  for (const char* joint : {"y_clavicle", "r_clavicle", "y_shoulder", "p_shoulder", "r_shoulder",
                            "elbow", "p_hip", "r_hip"})
    for (const char* side : {"l_", "r_"}) set(std::string(side) + joint, 0.3);
  for (const char* joint : {"wrist", "ankle"}) {
    const Eigen::Vector3d left = origin(std::string("l_") + joint);
    const Eigen::Vector3d right = origin(std::string("r_") + joint);
    EXPECT_TRUE(left.isApprox(Eigen::Vector3d(right.x(), -right.y(), right.z()), 1e-9)) << joint;
  }
}

TEST_F(HumanTest, chainOfExponentialsEqualsTheProductOfLocalTransforms) {
  for (int i = 0; i < model_.angleCount(); ++i) angles_[i] = std::sin(3.0 * i + 1.0);
  T_world_root_ = Eigen::Translation3d(1, -2, 0.9) *
                  Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized());
  LinkPoses poses;
  model_.forwardKinematics(T_world_root_, angles_, poses);
  LinkPoses expected(poses.size());
  expected[0] = T_world_root_;
  for (const BodyJoint& joint : model_.joints()) {
    const double angle = joint.angle_index < 0 ? 0.0 : angles_[joint.angle_index];
    expected[joint.child_link] =
        expected[joint.parent_link] * joint.T_parent_joint * Eigen::AngleAxisd(angle, joint.axis);
    EXPECT_TRUE(poses[joint.child_link].isApprox(expected[joint.child_link], 1e-9)) << joint.name;
  }
}

TEST_F(HumanTest, has27AnglesInAFixedOrderWithRoomToMove) {
  const std::vector<std::string> names = model_.angleNames();
  ASSERT_EQ(names.size(), 27u);
  EXPECT_EQ(names.front(), "waist_person1");
  EXPECT_EQ(names[4], "p_head_person1");
  EXPECT_EQ(names[7], "l_y_shoulder_person1");
  EXPECT_EQ(names.back(), "r_ankle_person1");
  EXPECT_EQ(model_.angleIndex("l_elbow"), 10);
  for (const BodyJoint& joint : model_.joints())
    EXPECT_TRUE(joint.angle_index < 0 || joint.lower < joint.upper) << joint.name;
}

TEST_F(HumanTest, hasAllLinksOfTheRep) {
  for (const char* link : {"body", "waist", "torso", "head"}) EXPECT_GE(model_.linkIndex(link), 0);
  for (const char* side : {"l_", "r_"})
    for (const char* link : {"shoulder", "elbow", "wrist", "hip", "knee", "ankle"})
      EXPECT_GE(model_.linkIndex(std::string(side) + link), 0);
}

TEST_F(HumanTest, markersSitAtTheJointCentres) {
  LinkPoses poses;
  model_.forwardKinematics(T_world_root_, angles_, poses);
  const auto positions = markerPositions(model_, poses);
  ASSERT_EQ(positions.size(), markerNames().size());
  ASSERT_EQ(markerNames().size(), 15u);
  EXPECT_EQ(markerNames()[0], "pelvis");
  EXPECT_LT((positions[0] - (origin("l_hip") + origin("r_hip")) / 2).norm(), 1e-9);
  EXPECT_EQ(markerNames()[1], "thorax");
  EXPECT_NEAR(positions[1].z(), lengths_.torso + lengths_.neck, 1e-5);
  EXPECT_EQ(markerNames()[5], "l_wrist");
  EXPECT_EQ(positions[5], origin("l_wrist"));
}

/// Litres of the shape's union in the zero pose, by counting cells of 1 cm.
double litres(const BodyModel& model) {
  LinkPoses poses;
  model.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(model.angleCount()),
                          poses);
  int inside = 0;
  for (double z = -1.0; z < 1.0; z += 0.01)
    for (double y = -0.5; y < 0.5; y += 0.01)
      for (double x = -0.3; x < 0.4; x += 0.01)
        for (const RoundCone& cone : model.shape()) {
          const Eigen::Vector3d a = poses[cone.link] * cone.a,
                                along = poses[cone.link] * cone.b - a;
          const Eigen::Vector3d p = Eigen::Vector3d(x, y, z) - a;
          const double s =
              std::clamp(p.dot(along) / std::max(along.squaredNorm(), 1e-12), 0.0, 1.0);
          if ((p - s * along).norm() > cone.radius_a) continue;
          ++inside;
          break;
        }
  return inside * 1e-3;
}

TEST_F(HumanTest, shapeHoldsAboutSeventyLitres) {
  EXPECT_NEAR(litres(model_), 70.0, 5.0);
}

TEST_F(HumanTest, shapeReachesFromTheSoleToTheStature) {
  LinkPoses poses;
  model_.forwardKinematics(T_world_root_, angles_, poses);
  double lowest = 0, highest = 0;
  for (const RoundCone& cone : model_.shape())
    for (const Eigen::Vector3d& end : {cone.a, cone.b}) {
      lowest = std::min(lowest, (poses[cone.link] * end).z() - cone.radius_a);
      highest = std::max(highest, (poses[cone.link] * end).z() + cone.radius_a);
    }
  EXPECT_NEAR(lowest, -0.530 * 1.75, 0.002);
  EXPECT_NEAR(highest - lowest, 1.75, 0.01);
}

TEST_F(HumanTest, wrongNumberOfAnglesIsRefused) {
  LinkPoses poses;
  EXPECT_EQ(errorTextOf(
                [&] { model_.forwardKinematics(T_world_root_, Eigen::VectorXd::Zero(3), poses); }),
            "body person1 has 27 joint angles, 3 were given");
}

TEST_F(HumanTest, unknownNamesAreRefused) {
  EXPECT_EQ(errorTextOf([&] { model_.linkIndex("tail"); }), "body person1 has no link tail");
  EXPECT_EQ(errorTextOf([&] { model_.joint("tail"); }), "body person1 has no joint tail");
  EXPECT_EQ(errorTextOf([&] { model_.angleIndex("torso"); }),
            "joint torso of body person1 is fixed and has no angle");
}

}  // namespace
}  // namespace markerless_mocap
