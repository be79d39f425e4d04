#pragma once

#include <string>
#include <vector>

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

/// Writes the files, see writeCloudFile(), and returns their names. Throws std::runtime_error or
/// std::invalid_argument if the output has another suffix, if there is no such bag, topic, grid or
/// hull, or if a file cannot be written.
std::vector<std::string> exportHulls(const HullExportOptions& what);

}  // namespace markerless_mocap
