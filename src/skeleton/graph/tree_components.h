#pragma once

#include <Eigen/Core>
#include <vector>

#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

/// Adds edges over gaps of at most `gap` metres between the component with the most nodes and the
/// next larger ones, nearest first. Returns which nodes hang together then.
std::vector<bool> joinComponents(const std::vector<Eigen::Vector3d>& positions, double gap,
                                 std::vector<TreeLinks::Edge>* edges);

}  // namespace markerless_mocap
