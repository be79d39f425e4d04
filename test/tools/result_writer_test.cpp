#include "tools/offline/result_writer.h"

#include <gtest/gtest.h>
#include <rosbag/view.h>
#include <sensor_msgs/JointState.h>

#include <algorithm>

#include "body/body_fixture.h"
#include "markerless_mocap/ros/messages.h"
#include "ros/camera_conversions.h"
#include "ros/ids_list.h"
#include "tools/tool_fixture.h"

namespace markerless_mocap {
namespace {

constexpr int64_t kSecond = 1000000000;
constexpr double kHeights[] = {1.0, 1.01, 0.99, 1.02, 1.0};
constexpr int kFrames = 5, kLostFrame = 3;

class ResultWriterTest : public ToolTest {
 protected:
  /// Of each instant with a pose.
  struct Written {
    std::vector<double> pose_height, tf_height, pose_elbow, state_elbow;
  };

  PipelineResult resultOf(int frame) const {
    PipelineResult result;
    BodyPose& pose = result.pose;
    if (frame == kLostFrame) return result;
    pose.status = PoseStatus::kTracked;
    pose.T_world_body.translation().z() = kHeights[frame];
    pose.angles = Eigen::VectorXd::Zero(model_->angleCount());
    pose.angles[model_->angleIndex("l_elbow")] = kHeights[frame];
    pose.part_seen.fill(true);
    return result;
  }

  Written written(bool filter) const {
    FilterOptions options;
    options.enabled = filter;
    BagWriter bag(path("results.bag"));
    ResultWriter writer(&bag, *model_, "world", makePoseFilter(model_, options));
    for (int f = 0; f < kFrames; ++f) writer.write(kSecond + f * kSecond / 30, resultOf(f));
    bag.commit();
    return readBack();
  }

  Written readBack() const {
    Written out;
    const auto elbow = [&](const std::vector<std::string>& names, const std::vector<double>& all) {
      const auto at = std::find(names.begin(), names.end(), "l_elbow_person1");
      return all.at(size_t(at - names.begin()));
    };
    rosbag::Bag bag(path("results.bag"));
    for (const rosbag::MessageInstance& message : rosbag::View(bag)) {
      if (const auto tf = message.instantiate<tf2_msgs::TFMessage>())
        out.tf_height.push_back(tf->transforms.front().transform.translation.z);
      if (const auto state = message.instantiate<sensor_msgs::JointState>())
        out.state_elbow.push_back(elbow(state->name, state->position));
      const auto pose = message.instantiate<BodyPoseMsg>();
      if (!pose || pose->status == BodyPoseMsg::LOST) continue;
      out.pose_height.push_back(pose->pose.position.z);
      out.pose_elbow.push_back(elbow(pose->joint_names, pose->joint_angles));
    }
    return out;
  }

  std::shared_ptr<const BodyModel> model_ = std::make_shared<const BodyModel>(human());
};

TEST_F(ResultWriterTest, PoseIsRawAndTransformsAndJointStatesAreFiltered) {
  const Written out = written(true);
  const std::vector<double> raw{kHeights[0], kHeights[1], kHeights[2], kHeights[4]};
  EXPECT_EQ(out.pose_height, raw);
  EXPECT_EQ(out.pose_elbow, raw);
  ASSERT_EQ(out.tf_height.size(), raw.size());
  ASSERT_EQ(out.state_elbow.size(), raw.size());
  EXPECT_GT(out.tf_height[2], raw[2] + 1e-4);  // between the last one and the raw one
  EXPECT_LT(out.tf_height[2], raw[1]);
  EXPECT_GT(out.state_elbow[2], raw[2] + 1e-4);
  EXPECT_LT(out.state_elbow[2], raw[1]);
  EXPECT_EQ(out.tf_height[3], raw[3]);  // begun anew after the loss
  EXPECT_EQ(out.state_elbow[3], raw[3]);
}

TEST_F(ResultWriterTest, WithoutFilterAllIsRaw) {
  const Written out = written(false);
  const std::vector<double> raw{kHeights[0], kHeights[1], kHeights[2], kHeights[4]};
  EXPECT_EQ(out.pose_height, raw);
  EXPECT_EQ(out.tf_height, raw);
  EXPECT_EQ(out.state_elbow, raw);
}

TEST_F(ResultWriterTest, TrackedBodiesAreLatchedWhenTheyChange) {
  written(true);
  rosbag::Bag bag(path("results.bag"));
  std::vector<std::pair<int64_t, std::vector<std::string>>> lists;
  for (const auto& message : rosbag::View(bag, rosbag::TopicQuery(kTrackedBodies))) {
    EXPECT_EQ(message.getConnectionHeader()->at("latching"), "1");
    const auto list = message.instantiate<IdsList>();
    ASSERT_TRUE(list);
    lists.emplace_back(nanosecondsOf(list->header.stamp), list->ids);
  }
  const auto stamp = [](int frame) { return kSecond + frame * kSecond / 30; };
  const decltype(lists) expected{
      {stamp(0), {"person1"}}, {stamp(kLostFrame), {}}, {stamp(kLostFrame + 1), {"person1"}}};
  EXPECT_EQ(lists, expected);
}

}  // namespace
}  // namespace markerless_mocap
