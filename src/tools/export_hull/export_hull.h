#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// Input and output of an export.
struct HullExportOptions {
  std::string input;   ///< bag with hulls and their grid
  std::string output;  ///< .pcd or .ply
  std::string topic = "/hull/points";
  double at = 0.0;   ///< seconds after the first hull: the first hull with voxels from there on
  bool all = false;  ///< export all hulls with voxels; the stamp becomes part of each file name
  bool ascii = false;
};

/// The points of a hull (voxel centres, m; colour; number of cameras that see the voxel) as a file
/// of the Point Cloud Library (version 0.7: x y z rgb views) or in the Stanford triangle format (x
/// y z red green blue views). Binary files are little-endian.
std::string pcdOf(const VisualHull& hull, bool ascii);
std::string plyOf(const VisualHull& hull, bool ascii);

/// Writes the files and returns their names. Throws std::runtime_error or std::invalid_argument if
/// the output has another suffix, if there is no such bag, topic, grid or hull, or if a file cannot
/// be written.
std::vector<std::string> exportHulls(const HullExportOptions& what);

}  // namespace markerless_mocap
