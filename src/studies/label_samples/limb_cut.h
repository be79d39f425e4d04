#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// A hull as after the loss of a limb in the silhouettes: in seven of ten cases an arm between
/// elbow and fingers is cut off, else a leg below the knee or the head. Returns the largest
/// component.
/// \param names of the true points, groundTruthNames()
/// \param points one per name, in the world, metres
VisualHull withLimbCut(const VisualHull& hull, const std::vector<std::string>& names,
                       const std::vector<Eigen::Vector3d>& points, std::mt19937* random);

}  // namespace markerless_mocap
