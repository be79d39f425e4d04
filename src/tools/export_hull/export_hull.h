#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// What to take out of a bag, and where to.
struct HullExportOptions {
  std::string input;   ///< bag with hulls and their grid
  std::string output;  ///< .pcd or .ply
  std::string topic = "/hull/points";
  double at = 0.0;   ///< seconds after the first hull; the first with voxels from there on
  bool all = false;  ///< all hulls with voxels, the stamp goes into each file's name
  bool ascii = false;
};

/// The points of a hull (voxel centres, m; colour; number of cameras that see the voxel) as a file
/// of the Point Cloud Library (version 0.7: x y z rgb views), resp. of the Stanford triangle format
/// (x y z red green blue views). Binary files are little-endian.
std::string pcdOf(const VisualHull& hull, bool ascii);
std::string plyOf(const VisualHull& hull, bool ascii);

/// Writes the files and returns their names. Throws std::runtime_error or std::invalid_argument
/// with one sentence: output of another kind, no such bag, topic, grid or hull, file not writable.
std::vector<std::string> exportHulls(const HullExportOptions& what);

}  // namespace markerless_mocap
