#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

struct Rejection {
  TreeStatus status;
  std::string reason;  ///< message for the user
};

/// Rejects hulls that cannot be one person, before thinning.
std::optional<Rejection> rejectHull(const VisualHull& hull);

/// Rejects skeletons that are too large to be processed.
std::optional<Rejection> rejectSkeleton(const CurveSkeleton& skeleton);

/// Rejects skeletons that cannot be one person's: those with hundreds of branches, or with a
/// noticeable part of the hull far away from the skeleton.
std::optional<Rejection> rejectSkeleton(const VisualHull& hull, const TreeGraph& graph);

}  // namespace markerless_mocap
