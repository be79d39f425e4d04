#pragma once

#include <optional>

#include "markerless_mocap/contour/contour_pose.h"
#include "markerless_mocap/skeleton/pose_tree.h"

namespace markerless_mocap {

/// The pose that a pose tree's joints tell; limbs without joints hang down. Empty without both hips
/// and the neck.
std::optional<ContourPose> poseOfTree(const PoseTree& tree);

}  // namespace markerless_mocap
