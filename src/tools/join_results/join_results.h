#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/common/result_record.h"

namespace markerless_mocap {

/// What is joined, and how well the parts must agree.
struct JoinOptions {
  std::string output;              ///< bag
  std::vector<std::string> parts;  ///< bags of mocap_offline, in the order of time
  std::string figures;             ///< file for ResultFigures; empty: none
  /// Largest distance of a joint between two parts, mean over the joints of a frame set, metres.
  double max_distance_m = 0.005;
};

/// Where one part ends and the next goes on, and how far apart they are before.
struct Seam {
  int64_t stamp_ns = 0;           ///< of the last frame set of the earlier part that is used
  int frame_sets = 0;             ///< at the end of the overlap, in which both agree
  double largest_distance_m = 0;  ///< of a frame set among these; 0 if neither has a pose in them
};

/// Two parts differ at the end of their overlap.
struct Disagreement : std::runtime_error {
  using std::runtime_error::runtime_error;
  size_t later_part = 0;  ///< index of the later one
};

/// Whether two neighbouring parts agree in the last second of their overlap: in each frame set both
/// have no pose, or both have one and the joints are close. The last quarter of a second of the
/// earlier part is left out, as images may be missing there. Throws Disagreement; later_part is 0.
Seam findSeam(const ResultRecord& earlier, const ResultRecord& later, double max_distance_m);

/// Joins the results of the parts of a recording to one bag, in which each frame set comes from one
/// part. The bag appears only if all parts agree. Throws Disagreement, or std::runtime_error if a
/// bag cannot be read or written.
std::vector<Seam> joinResults(const JoinOptions& options);

}  // namespace markerless_mocap
