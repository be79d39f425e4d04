#include "ros/pose_tree_conversions.h"

#include <sensor_msgs/point_cloud2_iterator.h>
#include <tf2_eigen/tf2_eigen.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "ros/message_limits.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxNodes = 100000;
constexpr int kStatusCount = int(TreeStatus::kUncertain) + 1;

static_assert(int(TreeStatus::kOk) == PoseTreeMsg::OK &&
              int(TreeStatus::kNoSkeleton) == PoseTreeMsg::NO_SKELETON &&
              int(TreeStatus::kNotAPerson) == PoseTreeMsg::NOT_A_PERSON &&
              int(TreeStatus::kTooFewBranches) == PoseTreeMsg::TOO_FEW_BRANCHES &&
              int(TreeStatus::kNoTorso) == PoseTreeMsg::NO_TORSO &&
              int(TreeStatus::kLowRank) == PoseTreeMsg::LOW_RANK &&
              int(TreeStatus::kSidesUnknown) == PoseTreeMsg::SIDES_UNKNOWN &&
              int(TreeStatus::kUncertain) == PoseTreeMsg::UNCERTAIN);
static_assert(int(TreePart::kNone) == PoseTreeMsg::NONE &&
              int(TreePart::kTorso) == PoseTreeMsg::TORSO &&
              int(TreePart::kNeck) == PoseTreeMsg::NECK &&
              int(TreePart::kLeftArm) == PoseTreeMsg::LEFT_ARM &&
              int(TreePart::kRightArm) == PoseTreeMsg::RIGHT_ARM &&
              int(TreePart::kLeftLeg) == PoseTreeMsg::LEFT_LEG &&
              int(TreePart::kRightLeg) == PoseTreeMsg::RIGHT_LEG);

void require(bool usable, const std::string& fault) {
  if (!usable) throw std::invalid_argument("PoseTree has " + fault);
}

template <class XyzT>
Eigen::Vector3d vectorOf(const XyzT& message, const char* what) {
  const Eigen::Vector3d p(message.x, message.y, message.z);
  require(p.allFinite(), std::string(what) + " that is not finite");
  require(isPlace(p), std::string(what) + " that is farther than 10 km");
  return p;
}

/// The enumerator whose toString() is the name.
template <class NamedT>
NamedT named(const std::string& name, int count, const char* kind) {
  for (int i = 0; i < count; ++i)
    if (name == toString(NamedT(i))) return NamedT(i);
  throw std::invalid_argument("PoseTree has the " + std::string(kind) + " \"" + name +
                              "\", which is unknown");
}

void checkNode(int32_t node, const PoseTree& tree, const char* what) {
  require(node >= -1 && node < int32_t(tree.nodes.size()), std::string(what) + " at node " +
                                                               std::to_string(node) + " of " +
                                                               std::to_string(tree.nodes.size()));
}

void readNodes(const PoseTreeMsg& message, PoseTree* tree) {
  const size_t count = message.nodes.size();
  require(count <= kMaxNodes,
          std::to_string(count) + " nodes, allowed are " + std::to_string(kMaxNodes));
  require(message.parents.size() == count && message.parts.size() == count,
          "nodes, parents and parts of different lengths");
  for (size_t i = 0; i < count; ++i) {
    const int32_t parent = message.parents[i];
    require(parent >= -1 && parent < int32_t(i), "a node before its parent");
    require(message.parts[i] < kTreePartCount,
            "the part " + std::to_string(message.parts[i]) + ", allowed are 0 to 6");
    tree->nodes.push_back(
        {vectorOf(message.nodes[i], "a node"), parent, TreePart(message.parts[i])});
  }
  checkNode(message.origin, *tree, "an origin");
  tree->origin = message.origin;
}

void readTips(const PoseTreeMsg& message, PoseTree* tree) {
  const size_t count = message.tip_names.size();
  require(message.tip_nodes.size() == count && message.tip_skeleton_ends.size() == count &&
              message.tip_positions.size() == count,
          "names, nodes and positions of tips of different lengths");
  for (size_t i = 0; i < count; ++i) {
    TreeExtremity& tip =
        tree->extremities[size_t(named<Extremity>(message.tip_names[i], kExtremityCount, "tip"))];
    checkNode(message.tip_nodes[i], *tree, "a tip");
    tip.node = message.tip_nodes[i];
    tip.skeleton_end = vectorOf(message.tip_skeleton_ends[i], "a tip");
    tip.position = vectorOf(message.tip_positions[i], "a tip");
  }
}

void readJoints(const PoseTreeMsg& message, PoseTree* tree) {
  require(message.joint_names.size() == message.joint_positions.size(),
          "names and positions of joints of different lengths");
  for (size_t i = 0; i < message.joint_names.size(); ++i)
    tree->joints[size_t(named<TreeJoint>(message.joint_names[i], kTreeJointCount, "joint"))] =
        vectorOf(message.joint_positions[i], "a joint");
}

}  // namespace

PoseTreeMsg messageFromPoseTree(const PoseTree& tree, const std_msgs::Header& header) {
  PoseTreeMsg message;
  message.header = header;
  message.status = uint8_t(tree.status);
  message.reason = tree.reason;
  message.rank = tree.rank;
  message.validity = tree.validity;
  for (const TreeNode& node : tree.nodes) {
    message.nodes.push_back(tf2::toMsg(node.position));
    message.parents.push_back(node.parent);
    message.parts.push_back(uint8_t(node.part));
  }
  message.origin = tree.origin;
  for (int i = 0; i < kExtremityCount; ++i) {
    const TreeExtremity& tip = tree.extremities[size_t(i)];
    if (tip.node < 0) continue;
    message.tip_names.emplace_back(toString(Extremity(i)));
    message.tip_nodes.push_back(tip.node);
    message.tip_skeleton_ends.push_back(tf2::toMsg(tip.skeleton_end));
    message.tip_positions.push_back(tf2::toMsg(tip.position));
  }
  for (int i = 0; i < kTreeJointCount; ++i) {
    const auto& joint = tree.joints[size_t(i)];
    if (!joint) continue;
    message.joint_names.emplace_back(toString(TreeJoint(i)));
    message.joint_positions.push_back(tf2::toMsg(*joint));
  }
  tf2::toMsg(tree.forward, message.forward);
  tf2::toMsg(tree.left, message.left);
  return message;
}

PoseTree poseTreeFromMessage(const PoseTreeMsg& message) {
  PoseTree tree;
  require(message.status < kStatusCount,
          "the status " + std::to_string(message.status) + ", allowed are 0 to 7");
  require(std::isfinite(message.rank) && std::isfinite(message.validity),
          "a rank or validity that is not finite");
  tree.status = TreeStatus(message.status);
  tree.reason = message.reason;
  tree.rank = message.rank;
  tree.validity = message.validity;
  readNodes(message, &tree);
  readTips(message, &tree);
  readJoints(message, &tree);
  tree.forward = vectorOf(message.forward, "a forward vector");
  tree.left = vectorOf(message.left, "a left vector");
  return tree;
}

sensor_msgs::PointCloud2 skeletonCloud(const PoseTree& tree, const std_msgs::Header& header) {
  sensor_msgs::PointCloud2 cloud;
  cloud.header = header;
  cloud.height = 1;
  cloud.is_dense = true;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(tree.skeleton.voxels.size());
  sensor_msgs::PointCloud2Iterator<float> xyz(cloud, "x");
  for (const uint32_t voxel : tree.skeleton.voxels) {
    const Eigen::Vector3f center = tree.skeleton.lattice.center(voxel).cast<float>();
    std::copy_n(center.data(), 3, &xyz[0]);
    ++xyz;
  }
  return cloud;
}

}  // namespace markerless_mocap
