#include "ros/truth_conversions.h"

#include <gtest/gtest.h>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

TEST(TruthConversions, everyPointHasItsName) {
  std_msgs::Header header;
  header.frame_id = "world";
  const auto message = messageFromPoints({"a", "b"}, {{1, 2, 3}, {4, 5, 6}}, header);
  EXPECT_EQ(message.header.frame_id, "world");
  EXPECT_EQ(message.names, (std::vector<std::string>{"a", "b"}));
  ASSERT_EQ(message.positions.size(), 2u);
  EXPECT_EQ(message.positions[1].x, 4.0);
  EXPECT_EQ(message.positions[1].y, 5.0);
  EXPECT_EQ(message.positions[0].z, 3.0);
  EXPECT_EQ(errorTextOf([&] { messageFromPoints({"a"}, {}, header); }), "1 names for 0 points");
}

TEST(TruthConversions, everyAngleHasItsJoint) {
  const BodyModel model = human();
  Eigen::VectorXd angles = Eigen::VectorXd::Zero(model.angleCount());
  angles[model.angleIndex("l_elbow")] = 0.7;
  const auto state = messageFromAngles(model, angles, std_msgs::Header());
  ASSERT_EQ(state.name.size(), size_t(model.angleCount()));
  for (size_t i = 0; i < state.name.size(); ++i)
    EXPECT_EQ(state.position[i], state.name[i] == "l_elbow_" + model.id() ? 0.7 : 0.0);
  EXPECT_NE(errorTextOf([&] { messageFromAngles(model, Eigen::VectorXd(), std_msgs::Header()); }),
            "");
}

}  // namespace
}  // namespace markerless_mocap
