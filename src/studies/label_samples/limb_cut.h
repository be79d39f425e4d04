#pragma once

#include <Eigen/Core>
#include <random>
#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// What is left of a hull when silhouettes have lost a limb from somewhere on: in seven of ten
/// cases an arm between elbow and fingers, else a leg below the knee or the head. The largest
/// component. \param names of the true points, groundTruthNames() \param points world metres
VisualHull withLimbCut(const VisualHull& hull, const std::vector<std::string>& names,
                       const std::vector<Eigen::Vector3d>& points, std::mt19937* random);

}  // namespace markerless_mocap
