#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

struct Rejection {
  TreeStatus status;
  std::string reason;  ///< one sentence
};

/// Whether a hull can be one person at all, before anything is made of it.
std::optional<Rejection> rejectHull(const VisualHull& hull);

/// Whether a skeleton is small enough to be looked into.
std::optional<Rejection> rejectSkeleton(const CurveSkeleton& skeleton);

/// Whether a skeleton can be one person's: it has not hundreds of branches, and next to no part of
/// the hull is out of the skeleton's reach.
std::optional<Rejection> rejectSkeleton(const VisualHull& hull, const TreeGraph& graph);

}  // namespace markerless_mocap
