#pragma once

#include <optional>

#include "contour/model/contour_pose.h"
#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

/// The pose from the joints of a pose tree; limbs without joints hang down. Empty without both hips
/// and the neck.
std::optional<ContourPose> poseFromPoseTree(const PoseTree& tree);

}  // namespace markerless_mocap
