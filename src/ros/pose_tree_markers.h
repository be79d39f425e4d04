#pragma once

#include <std_msgs/Header.h>
#include <visualization_msgs/MarkerArray.h>

#include <array>
#include <cstdint>

#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

/// Colour of a part in all displays, red green blue; arms and legs as in partColor().
std::array<uint8_t, 3> treeColor(TreePart part);

/// The edges of the tree in the colours of their parts, labelled spheres at the extremities, and an
/// arrow from the origin in the forward direction. An invalid tree is faint, with the reason above
/// it. Other markers are deleted.
visualization_msgs::MarkerArray treeMarkers(const PoseTree& tree, const std_msgs::Header& header);

}  // namespace markerless_mocap
