#include "ros/latest_transforms.h"

#include <gtest/gtest.h>

#include <cmath>

#include "ros/placed_camera.h"

namespace markerless_mocap {
namespace {

class Transforms : public ::testing::Test {
 protected:
  Transforms() { rig_.add(0, infoIn("a_optical")); }
  void send(double x, double stamp) {
    geometry_msgs::TransformStamped transform;
    transform.header.frame_id = "world";
    transform.header.stamp = ros::Time(stamp);
    transform.child_frame_id = "a_optical";
    transform.transform = samplePose();
    transform.transform.translation.x = x;
    tf2_msgs::TFMessage message;
    message.transforms.push_back(transform);
    latest_.add(message, "/driver", false, ++arrival_ns_);
  }
  double x() const {
    return latest_.buffer()
        .lookupTransform("world", "a_optical", ros::Time(0))
        .transform.translation.x;
  }

  LatestTransforms latest_;
  RigCollector rig_{{"a"}, "world"};
  int64_t arrival_ns_ = 5'000'000'000;
};

TEST_F(Transforms, AreTakenWhenTheSendersClockIsSet) {
  send(1.0, 1e6);
  EXPECT_EQ(x(), 1.0);
  send(2.0, 1e6 + 1000.0);
  EXPECT_EQ(x(), 2.0);
  send(3.0, 1e6 + 0.1);
  EXPECT_EQ(x(), 3.0);
  send(4.0, 0.0);
  EXPECT_EQ(x(), 4.0);
}

TEST_F(Transforms, WhatTf2DoesNotTakeIsToldUntilTheSameFrameComesRight) {
  send(1.0, 1e6);
  EXPECT_TRUE(latest_.faults(rig_).empty());
  send(std::nan(""), 1e6);
  EXPECT_EQ(latest_.faults(rig_),
            std::vector<std::string>{"/driver has sent a transform of a_optical to tf that is not "
                                     "used: it holds a value that is not a number"});
  EXPECT_EQ(x(), 1.0);
  send(2.0, 1e6);
  EXPECT_TRUE(latest_.faults(rig_).empty());
}

TEST_F(Transforms, FaultsOfFramesThatNoCameraNeedsAreNotTold) {
  RigCollector other({"b"}, "world");
  other.add(0, infoIn("b_optical"));
  send(std::nan(""), 1e6);
  EXPECT_TRUE(latest_.faults(other).empty());
}

}  // namespace
}  // namespace markerless_mocap
