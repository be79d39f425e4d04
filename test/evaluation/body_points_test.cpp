#include "evaluation/body_points.h"

#include <gtest/gtest.h>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

Eigen::Matrix3Xd standing(const BodyModel& model) {
  LinkPoses T_world_link;
  model.forwardKinematics(Eigen::Isometry3d(Eigen::Translation3d(0, 0, 1)),
                          Eigen::VectorXd::Zero(model.angleCount()), T_world_link);
  return bodyPoints(model, T_world_link);
}

Eigen::Vector3d at(const Eigen::Matrix3Xd& points, const std::string& name) {
  const auto names = bodyPointNames();
  return points.col(std::find(names.begin(), names.end(), name) - names.begin());
}

TEST(BodyPoints, TipsLieWhereTheLengthsOfThePersonPutThem) {
  const BodyProportions lengths = BodyProportions::fromStature(1.75);
  const Eigen::Matrix3Xd points = standing(human());
  // Arms hang: finger tips one hand below the wrist, knuckles at 0.53 of it.
  EXPECT_NEAR((at(points, "l_wrist") - at(points, "l_hand_tip")).z(), lengths.hand, 1e-6);
  EXPECT_NEAR((at(points, "r_wrist") - at(points, "r_hand")).z(), 0.53 * lengths.hand, 1e-6);
  // The foot reaches from a quarter behind the ankle to three quarters before it.
  EXPECT_NEAR((at(points, "l_foot_tip") - at(points, "l_ankle")).x(), 0.76 * lengths.foot, 1e-6);
  EXPECT_NEAR((at(points, "l_foot") - at(points, "l_ankle")).x(), 0.48 * lengths.foot, 1e-6);
  // Hair rounds the head off to within a few millimetres of its length.
  EXPECT_NEAR((at(points, "head_top") - at(points, "thorax")).z(), lengths.head, 0.005);
}

TEST(BodyPoints, MarkersComeFirst) {
  const BodyModel model = human();
  LinkPoses T_world_link;
  model.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(model.angleCount()),
                          T_world_link);
  const auto markers = markerPositions(model, T_world_link);
  const Eigen::Matrix3Xd points = bodyPoints(model, T_world_link);
  for (size_t i = 0; i < markers.size(); ++i) EXPECT_EQ(points.col(i), markers[i]);
}

TEST(BodyPoints, SolesAreTheLowestPointsOfTheFeet) {
  const BodyModel model = human();
  const BodyProportions lengths = BodyProportions::fromStature(1.75);
  const Eigen::Isometry3d T_world_body(Eigen::Translation3d(0, 0, 1));
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(model.angleCount());
  LinkPoses T_world_link;
  model.forwardKinematics(T_world_body, angles, T_world_link);
  const double ankle = T_world_link[size_t(model.linkIndex("l_ankle"))].translation().z();
  EXPECT_NEAR(soleHeights(model, T_world_link)[0], ankle - lengths.ankle_height, 1e-6);
  EXPECT_NEAR(soleHeights(model, T_world_link)[1], ankle - lengths.ankle_height, 1e-6);
  angles[model.angleIndex("r_knee")] = -M_PI / 2;  // toes down
  model.forwardKinematics(T_world_body, angles, T_world_link);
  const double knee = T_world_link[size_t(model.linkIndex("r_knee"))].translation().z();
  EXPECT_NEAR(soleHeights(model, T_world_link)[1], knee - 0.76 * lengths.foot, 1e-6);
  T_world_link[size_t(model.linkIndex("r_ankle"))].matrix().setConstant(NAN);
  EXPECT_TRUE(std::isnan(soleHeights(model, T_world_link)[1]));
}

TEST(BodyPoints, OfALinkThatIsNotSeenAreMissing) {
  const BodyModel model = human();
  LinkPoses T_world_link;
  model.forwardKinematics(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(model.angleCount()),
                          T_world_link);
  T_world_link[model.linkIndex("l_wrist")].matrix().setConstant(NAN);
  const Eigen::Matrix3Xd points = bodyPoints(model, T_world_link);
  EXPECT_TRUE(at(points, "l_hand_tip").array().isNaN().all());
  EXPECT_TRUE(at(points, "r_hand_tip").allFinite());
}

}  // namespace
}  // namespace markerless_mocap
