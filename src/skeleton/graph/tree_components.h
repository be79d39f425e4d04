#pragma once

#include <Eigen/Core>
#include <vector>

#include "skeleton/graph/tree_graph.h"

namespace markerless_mocap {

/// Joins the next largest components to the largest one by edges over gaps of up to `gap` metres,
/// the nearest first.
/// \return for each node whether it is connected to the largest component
std::vector<bool> joinComponents(const std::vector<Eigen::Vector3d>& positions, double gap,
                                 std::vector<TreeLinks::Edge>* edges);

}  // namespace markerless_mocap
