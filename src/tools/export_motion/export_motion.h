#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Input and output of an export.
struct MotionExportOptions {
  std::string input;                ///< bag with results
  std::string output;               ///< its suffix is the format
  std::string body_id;              ///< empty: the only body
  std::string urdf;                 ///< file; empty: the bag's description
  std::string names;                ///< nameSets(); empty: those that are usual for the format
  std::vector<std::string> joints;  ///< points to write; empty: all
  double fill_ms = 0.0;             ///< longest gap to fill; 0: none
  bool metres = false;              ///< of a BVH file, instead of centimetres
  bool angles = false;              ///< in a CSV file, instead of points
};

/// The suffixes with a sentence for each, for the help.
std::string motionFormats();

/// Writes the file, and for formats that cannot say it themselves a table of gaps beside it,
/// <output>.gaps.csv, if there are any. Nothing is left half-written. Throws std::runtime_error or
/// std::invalid_argument as readPersonMotion(), on an unknown suffix, name set or joint, options
/// that the format does not have, or if a file cannot be written.
/// \param notes what a user should know about the motion, one sentence a line
void exportMotion(const MotionExportOptions& what, std::ostream& notes);

}  // namespace markerless_mocap
