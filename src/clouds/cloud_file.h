#pragma once

#include <string>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Writes the points of a hull with the Point Cloud Library: .pcd (all fields of HullPoint) or .ply
/// (x y z red green blue, and the other fields as they are). Throws std::runtime_error if the file
/// cannot be written; it is complete or as it was.
void writeCloudFile(const std::string& path, const VisualHull& hull, bool ascii);

}  // namespace markerless_mocap
