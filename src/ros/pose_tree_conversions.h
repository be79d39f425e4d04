#pragma once

#include <sensor_msgs/PointCloud2.h>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/ros/messages.h"

namespace markerless_mocap {

/// The tree without the skeleton, which is published as skeletonCloud(). Extremities and joints
/// that were not found are left out.
PoseTreeMsg messageFromPoseTree(const PoseTree& tree, const std_msgs::Header& header);

/// The tree from its message, without the skeleton. Throws std::invalid_argument on an unknown
/// status, part or name, lists of different lengths, a parent that is not before its child, an
/// invalid node index, or a value that is not finite.
PoseTree poseTreeFromMessage(const PoseTreeMsg& message);

/// Centre of each voxel of the skeleton: x y z (float32, metres).
sensor_msgs::PointCloud2 skeletonCloud(const PoseTree& tree, const std_msgs::Header& header);

}  // namespace markerless_mocap
