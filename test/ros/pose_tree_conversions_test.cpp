#include "ros/pose_tree_conversions.h"

#include <gtest/gtest.h>
#include <sensor_msgs/point_cloud2_iterator.h>

#include <algorithm>
#include <limits>
#include <stdexcept>
#include <string>

#include "error_text_of.h"
#include "ros/pose_tree_markers.h"
#include "ros/world_header.h"

namespace markerless_mocap {
namespace {

using visualization_msgs::Marker;

/// A head, a left hand and five nodes between them; the rest is not found.
PoseTree sampleTree() {
  PoseTree tree;
  tree.status = TreeStatus::kUncertain;
  tree.reason = "such trees are labelled wrong too often";
  tree.rank = 0.25;
  tree.validity = 0.125;
  const TreePart parts[] = {TreePart::kNeck, TreePart::kNeck, TreePart::kTorso, TreePart::kLeftArm,
                            TreePart::kNone};
  for (int i = 0; i < 5; ++i)
    tree.nodes.push_back({{0.1 * i, 0.2, 1.5}, i < 3 ? i - 1 : 1, parts[i]});
  tree.origin = 1;
  tree.extremities[size_t(Extremity::kHead)] = {0, {0.0, 0.2, 1.5}, {0.0, 0.2, 1.4}};
  tree.extremities[size_t(Extremity::kLeftHand)] = {3, {0.3, 0.2, 1.5}, {0.25, 0.2, 1.5}};
  tree.joints[size_t(TreeJoint::kLeftElbow)] = Eigen::Vector3d(0.2, 0.2, 1.5);
  tree.forward = Eigen::Vector3d::UnitX();
  tree.left = Eigen::Vector3d::UnitY();
  tree.skeleton.lattice.size = {10, 10, 10};
  tree.skeleton.voxels = {3, 4, 700};
  return tree;
}

PoseTreeMsg sampleMessage() {
  return messageFromPoseTree(sampleTree(), worldHeader());
}

/// What the sample is refused for after a change.
template <class ChangeT>
std::string refusalAfter(ChangeT change) {
  PoseTreeMsg message = sampleMessage();
  change(&message);
  return errorTextOf([&] { poseTreeFromMessage(message); });
}

const Marker& find(const visualization_msgs::MarkerArray& markers, const std::string& group,
                   int id) {
  const auto found =
      std::find_if(markers.markers.begin(), markers.markers.end(),
                   [&](const Marker& marker) { return marker.ns == group && marker.id == id; });
  if (found == markers.markers.end()) throw std::out_of_range(group);
  return *found;
}

TEST(PoseTreeConversions, TreeComesBackAsItWas) {
  const PoseTree there = sampleTree(), back = poseTreeFromMessage(sampleMessage());
  EXPECT_EQ(back.status, there.status);
  EXPECT_EQ(back.reason, there.reason);
  EXPECT_EQ(back.rank, there.rank);
  EXPECT_EQ(back.validity, there.validity);
  ASSERT_EQ(back.nodes.size(), there.nodes.size());
  for (size_t i = 0; i < there.nodes.size(); ++i) {
    EXPECT_EQ(back.nodes[i].position, there.nodes[i].position);
    EXPECT_EQ(back.nodes[i].parent, there.nodes[i].parent);
    EXPECT_EQ(back.nodes[i].part, there.nodes[i].part);
  }
  EXPECT_EQ(back.origin, there.origin);
  for (size_t i = 0; i < there.extremities.size(); ++i) {
    EXPECT_EQ(back.extremities[i].node, there.extremities[i].node);
    EXPECT_EQ(back.extremities[i].skeleton_end, there.extremities[i].skeleton_end);
    EXPECT_EQ(back.extremities[i].position, there.extremities[i].position);
  }
  EXPECT_EQ(back.joints, there.joints);
  EXPECT_EQ(back.forward, there.forward);
  EXPECT_EQ(back.left, there.left);
}

TEST(PoseTreeConversions, OnlyWhatIsFoundIsNamed) {
  const PoseTreeMsg message = sampleMessage();
  EXPECT_EQ(message.header.stamp, ros::Time(1000, 7));
  EXPECT_EQ(message.header.frame_id, "world");
  EXPECT_EQ(message.tip_names, (std::vector<std::string>{"head", "left_hand"}));
  EXPECT_EQ(message.joint_names, std::vector<std::string>{"l_elbow"});
  EXPECT_EQ(message.parts[3], PoseTreeMsg::LEFT_ARM);
}

TEST(PoseTreeConversions, NothingFoundIsAMessageTooAndComesBack) {
  PoseTree nothing;
  nothing.reason = "the hull is empty";
  const PoseTreeMsg message = messageFromPoseTree(nothing, worldHeader());
  EXPECT_EQ(message.status, PoseTreeMsg::NO_SKELETON);
  EXPECT_TRUE(message.nodes.empty() && message.tip_names.empty() && message.joint_names.empty());
  EXPECT_EQ(poseTreeFromMessage(message).reason, "the hull is empty");
}

TEST(PoseTreeConversions, BadMessagesAreRefusedInASentence) {
  EXPECT_EQ(refusalAfter([](PoseTreeMsg*) {}), "");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->status = 8; }),
            "PoseTree has the status 8, allowed are 0 to 7");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->parts[0] = 7; }),
            "PoseTree has the part 7, allowed are 0 to 6");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->parents[2] = 2; }),
            "PoseTree has a node before its parent");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->parents.pop_back(); }),
            "PoseTree has nodes, parents and parts of different lengths");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->origin = 5; }),
            "PoseTree has an origin at node 5 of 5");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->tip_nodes[1] = 9; }),
            "PoseTree has a tip at node 9 of 5");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->tip_names[0] = "nose"; }),
            "PoseTree has the tip \"nose\", which is unknown");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->tip_positions.clear(); }),
            "PoseTree has names, nodes and positions of tips of different lengths");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->joint_names[0] = "l_wing"; }),
            "PoseTree has the joint \"l_wing\", which is unknown");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->joint_names.emplace_back("r_elbow"); }),
            "PoseTree has names and positions of joints of different lengths");
}

TEST(PoseTreeConversions, WhatIsOutsideOfAnyRoomIsRefused) {
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* message) { message->nodes[2].x = 1e300; }),
            "PoseTree has a node that is farther than 10 km");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* message) {
              message->nodes.resize(200000);
              message->parents.resize(200000);
              message->parts.resize(200000);
            }),
            "PoseTree has 200000 nodes, allowed are 100000");
}

TEST(PoseTreeConversions, WhatIsNotFiniteIsRefused) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->validity = kNan; }),
            "PoseTree has a rank or validity that is not finite");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->nodes[4].y = kInfinity; }),
            "PoseTree has a node that is not finite");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->tip_skeleton_ends[0].x = kNan; }),
            "PoseTree has a tip that is not finite");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->joint_positions[0].z = kNan; }),
            "PoseTree has a joint that is not finite");
  EXPECT_EQ(refusalAfter([](PoseTreeMsg* m) { m->left.x = kNan; }),
            "PoseTree has a left vector that is not finite");
}

TEST(PoseTreeConversions, SkeletonIsItsVoxelsCentres) {
  const PoseTree tree = sampleTree();
  const sensor_msgs::PointCloud2 cloud = skeletonCloud(tree, worldHeader());
  ASSERT_EQ(cloud.width, 3u);
  sensor_msgs::PointCloud2ConstIterator<float> xyz(cloud, "x");
  for (const uint32_t voxel : tree.skeleton.voxels) {
    const Eigen::Vector3f center = tree.skeleton.lattice.center(voxel).cast<float>();
    EXPECT_EQ(Eigen::Vector3f(xyz[0], xyz[1], xyz[2]), center);
    ++xyz;
  }
  EXPECT_EQ(skeletonCloud(PoseTree(), worldHeader()).width, 0u);
}

TEST(PoseTreeMarkers, EachEdgeHasItsPartsColour) {
  const auto markers = treeMarkers(sampleTree(), worldHeader());
  const Marker& edges = find(markers, "tree", 0);
  ASSERT_EQ(edges.points.size(), 8u);  // four nodes have a parent
  ASSERT_EQ(edges.colors.size(), 8u);
  EXPECT_DOUBLE_EQ(edges.points[5].x, 0.3);  // the arm's node
  EXPECT_EQ(edges.colors[5].r, treeColor(TreePart::kLeftArm)[0] / 255.0f);
  EXPECT_LT(edges.colors[5].a, 1.0f);  // nobody may believe it
}

TEST(PoseTreeMarkers, TipsAreNamedAndThoseNotFoundTakenAway) {
  const auto markers = treeMarkers(sampleTree(), worldHeader());
  EXPECT_EQ(find(markers, "tip_names", int(Extremity::kLeftHand)).text, "left hand");
  EXPECT_EQ(find(markers, "tips", int(Extremity::kLeftHand)).pose.position.x, 0.25);
  for (const char* group : {"tips", "tip_names"})
    for (int i = 0; i < kExtremityCount; ++i)
      EXPECT_EQ(find(markers, group, i).action, i < 2 ? Marker::ADD : Marker::DELETE) << group << i;
}

TEST(PoseTreeMarkers, ArrowPointsForwardFromTheOrigin) {
  const auto markers = treeMarkers(sampleTree(), worldHeader());
  const Marker& arrow = find(markers, "forward", 0);
  ASSERT_EQ(arrow.points.size(), 2u);
  EXPECT_EQ(arrow.points[0].x, 0.1);
  EXPECT_GT(arrow.points[1].x, 0.3);
  EXPECT_EQ(arrow.points[1].y, 0.2);
}

TEST(PoseTreeMarkers, ReasonIsShownUnlessTheTreeIsValid) {
  PoseTree tree = sampleTree();
  EXPECT_EQ(find(treeMarkers(tree, worldHeader()), "reason", 0).text, tree.reason);
  EXPECT_LT(find(treeMarkers(tree, worldHeader()), "tip_names", 0).color.a, 0.5f);
  tree.status = TreeStatus::kOk;
  const auto markers = treeMarkers(tree, worldHeader());
  EXPECT_EQ(find(markers, "reason", 0).action, Marker::DELETE);
  EXPECT_EQ(find(markers, "tip_names", 0).color.a, 1.0f);
  EXPECT_EQ(find(markers, "tree", 0).colors[5].a, 1.0f);
}

TEST(PoseTreeMarkers, NothingFoundTakesEveryMarkerAway) {
  for (const Marker& marker : treeMarkers(PoseTree(), worldHeader()).markers)
    EXPECT_EQ(marker.action, Marker::DELETE) << marker.ns << marker.id;
}

}  // namespace
}  // namespace markerless_mocap
