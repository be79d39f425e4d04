#pragma once

#include <optional>
#include <vector>

#include "markerless_mocap/contour/contour_body.h"
#include "markerless_mocap/hull/visual_hull.h"
#include "markerless_mocap/skeleton/pose_tree.h"

namespace markerless_mocap {

/// The pose that a pose tree's joints tell; limbs without joints hang down. Empty without both hips
/// and the neck.
std::optional<ContourPose> poseOfTree(const PoseTree& tree);

/// Upright poses where the hull is, arms hanging, that face in directions all around. Empty without
/// a hull.
std::vector<ContourPose> uprightPoses(const VisualHull& hull, const ContourBody& body);

}  // namespace markerless_mocap
