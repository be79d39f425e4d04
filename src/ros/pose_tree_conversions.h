#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <cstdint>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// Colour of a part wherever it is shown, red green blue; arms and legs as by partColor().
std::array<uint8_t, 3> treeColor(TreePart part);

/// All but the skeleton, which travels as skeletonCloud(). Tips and joints that are not found are
/// left out.
PoseTreeMsg messageFromPoseTree(const PoseTree& tree, const std_msgs::Header& header);

/// The tree back, without its skeleton. Throws std::invalid_argument on an unknown status, part or
/// name, lists that differ in length, a parent behind its child, a node that is none, or a value
/// that is not finite.
PoseTree poseTreeFromMessage(const PoseTreeMsg& message);

/// x y z (float32, metres) of each voxel of the skeleton.
sensor_msgs::PointCloud2 skeletonCloud(const PoseTree& tree, const std_msgs::Header& header);

/// The tree's edges in the colours of their parts, named balls at the tips and an arrow forward
/// from the origin; faint, with the reason above, unless the tree is valid. What is not there is
/// deleted.
visualization_msgs::MarkerArray treeMarkers(const PoseTree& tree, const std_msgs::Header& header);

}  // namespace markerless_mocap
