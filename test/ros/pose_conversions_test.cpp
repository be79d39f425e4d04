#include "ros/pose_conversions.h"

#include <gtest/gtest.h>
#include <tf2/buffer_core.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "body/body_fixture.h"
#include "ros/world_header.h"

namespace markerless_mocap {
namespace {

const BodyModel& person() {
  static const BodyModel model = human();
  return model;
}

BodyPose samplePose() {
  BodyPose pose;
  pose.status = PoseStatus::kTracked;
  pose.T_world_body.translation() << 0.3, -0.2, 0.9;
  pose.T_world_body.linear() =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  pose.angles = Eigen::VectorXd::LinSpaced(person().angleCount(), 0.01, 0.2);
  pose.part_seen.fill(true);
  pose.skeleton_error_m = 0.02;
  pose.silhouette_overlap = 0.9;
  pose.part_sigma_m[size_t(PartLabel::kLeg2)] = 0.03;
  return pose;
}

bool anyContains(const std::vector<std::string>& names, const std::string& word) {
  return std::any_of(names.begin(), names.end(),
                     [&](const std::string& n) { return n.find(word) != std::string::npos; });
}

TEST(PoseConversions, TrackedPoseCarriesEveryJoint) {
  const BodyPoseMsg message = messageFromPose(person(), samplePose(), worldHeader());
  EXPECT_EQ(message.status, BodyPoseMsg::TRACKED);
  EXPECT_EQ(message.body_id, "person1");
  EXPECT_EQ(message.joint_names.size(), size_t(person().angleCount()));
  EXPECT_TRUE(message.parts_not_seen.empty());
  EXPECT_DOUBLE_EQ(message.skeleton_error, 0.02);
  EXPECT_DOUBLE_EQ(message.silhouette_overlap, 0.9);
  EXPECT_DOUBLE_EQ(message.part_deviation[5], 0.03);  // r_leg
  EXPECT_DOUBLE_EQ(message.pose.position.z, 0.9);
}

TEST(PoseConversions, AnglesGoWithTheirNames) {
  const sensor_msgs::JointState state = jointStateFromPose(person(), samplePose(), worldHeader());
  const std::vector<std::string> names = person().angleNames();
  EXPECT_EQ(state.header.stamp, ros::Time(1000, 7));
  for (size_t i = 0; i < state.name.size(); ++i) {
    const size_t at = std::find(names.begin(), names.end(), state.name[i]) - names.begin();
    ASSERT_LT(at, names.size());
    EXPECT_DOUBLE_EQ(state.position[i], samplePose().angles[at]);
  }
}

TEST(PoseConversions, UnseenArmIsLeftOutAndNamed) {
  BodyPose pose = samplePose();
  pose.part_seen[size_t(PartLabel::kArm1)] = false;
  const BodyPoseMsg message = messageFromPose(person(), pose, worldHeader());
  EXPECT_EQ(message.parts_not_seen, std::vector<std::string>{"l_arm"});
  EXPECT_FALSE(anyContains(message.joint_names, "l_elbow"));
  EXPECT_TRUE(anyContains(message.joint_names, "r_elbow"));
  for (const auto& transform : linkTransforms(person(), pose, worldHeader()))
    EXPECT_EQ(transform.child_frame_id.find("l_elbow"), std::string::npos);
}

TEST(PoseConversions, FramesOfSeenArmsConnectThroughATrunkThatIsNot) {
  BodyPose pose = samplePose();
  pose.part_seen.fill(false);
  pose.part_seen[size_t(PartLabel::kArm1)] = true;
  tf2::BufferCore tf;
  for (const auto& transform : linkTransforms(person(), pose, worldHeader()))
    tf.setTransform(transform, "test");
  EXPECT_TRUE(tf.canTransform("world", "l_wrist_person1", ros::Time(1000, 7)));
  for (const std::string frame : {"head_person1", "r_elbow_person1", "l_knee_person1"})
    EXPECT_FALSE(tf.canTransform("world", frame, ros::Time(1000, 7))) << frame;
  EXPECT_FALSE(anyContains(jointStateFromPose(person(), pose, worldHeader()).name, "waist"));
}

TEST(PoseConversions, LostPoseCarriesNothingButTheReason) {
  BodyPose pose = samplePose();
  pose.status = PoseStatus::kLost;
  pose.reason = "the hull has no voxels";
  const BodyPoseMsg message = messageFromPose(person(), pose, worldHeader());
  EXPECT_EQ(message.status, BodyPoseMsg::LOST);
  EXPECT_EQ(message.reason, pose.reason);
  EXPECT_TRUE(message.joint_names.empty());
  EXPECT_TRUE(std::isnan(messageFromPose(person(), BodyPose(), worldHeader()).part_deviation[0]));
  EXPECT_TRUE(jointStateFromPose(person(), pose, worldHeader()).name.empty());
  EXPECT_THROW(rootTransform(person(), pose, worldHeader()), std::invalid_argument);
}

TEST(PoseConversions, NaNIsNeverPublishedAsAPose) {
  BodyPose pose = samplePose();
  pose.angles[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(messageFromPose(person(), pose, worldHeader()), std::invalid_argument);
  EXPECT_THROW(linkTransforms(person(), pose, worldHeader()), std::invalid_argument);
  pose = samplePose();
  pose.T_world_body.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(rootTransform(person(), pose, worldHeader()), std::invalid_argument);
}

TEST(PoseConversions, TransformsChainToTheLinkPoses) {
  tf2::BufferCore tf;
  for (const auto& transform : linkTransforms(person(), samplePose(), worldHeader()))
    tf.setTransform(transform, "test");
  LinkPoses T_world_link;
  person().forwardKinematics(samplePose().T_world_body, samplePose().angles, T_world_link);
  for (const std::string base : {"head", "l_wrist", "r_ankle"}) {
    const auto found = tf.lookupTransform("world", base + "_person1", ros::Time(1000, 7));
    EXPECT_TRUE(tf2::transformToEigen(found).isApprox(T_world_link[person().linkIndex(base)], 1e-9))
        << base;
  }
}

}  // namespace
}  // namespace markerless_mocap
