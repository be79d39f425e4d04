#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/products/pose_tree.h"
#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

struct Refusal {
  TreeStatus status;
  std::string reason;  ///< one sentence
};

/// Whether a hull can be one person at all, before anything is made of it.
std::optional<Refusal> refuseHull(const VisualHull& hull);

/// Whether a skeleton is small enough to be looked into.
std::optional<Refusal> refuseSkeleton(const CurveSkeleton& skeleton);

/// Whether a skeleton can be one person's: it has not hundreds of branches, and next to no part of
/// the hull is out of the skeleton's reach.
std::optional<Refusal> refuseSkeleton(const VisualHull& hull, const TreeGraph& graph);

}  // namespace markerless_mocap
