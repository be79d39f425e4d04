#pragma once

#include <sensor_msgs/PointCloud2.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <cstdint>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// Colour of a part in all displays, red green blue; arms and legs as in partColor().
std::array<uint8_t, 3> treeColor(TreePart part);

/// The tree without the skeleton, which is published as skeletonCloud(). Extremities and joints
/// that were not found are left out.
PoseTreeMsg messageFromPoseTree(const PoseTree& tree, const std_msgs::Header& header);

/// The tree from its message, without the skeleton. Throws std::invalid_argument on an unknown
/// status, part or name, lists of different lengths, a parent that is not before its child, an
/// invalid node index, or a value that is not finite.
PoseTree poseTreeFromMessage(const PoseTreeMsg& message);

/// Centre of each voxel of the skeleton: x y z (float32, metres).
sensor_msgs::PointCloud2 skeletonCloud(const PoseTree& tree, const std_msgs::Header& header);

/// The edges of the tree in the colours of their parts, labelled spheres at the extremities, and an
/// arrow from the origin in the forward direction. An invalid tree is faint, with the reason above
/// it. Other markers are deleted.
visualization_msgs::MarkerArray treeMarkers(const PoseTree& tree, const std_msgs::Header& header);

}  // namespace markerless_mocap
