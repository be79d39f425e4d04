#pragma once

#include <map>
#include <string>
#include <vector>

#include "evaluation/part_error.h"

namespace markerless_mocap {

/// What a bag says that the segmentation stage found.
struct PartsRecord {
  std::string world_frame;
  std::vector<int64_t> stamps_ns;  ///< ascending
  std::vector<SegmentedHull> hulls;
  std::vector<std::string> statuses, reasons;
};

/// Reads /segmentation/points, /segmentation/parts and /hull/grid; no stamps without them. Throws
/// std::runtime_error if the bag cannot be read, std::invalid_argument on a message that cannot be
/// what it should.
PartsRecord readParts(const std::string& path);

/// Segmented hulls held against the truth.
struct PartsEvaluation {
  PartErrors errors;
  std::map<std::string, size_t> status_counts;  ///< of the truth's frames; "missing": nothing said
  std::vector<std::string> reasons;             ///< per frame of the truth; empty when valid
};

/// \param truth with partTruthNames() \param tolerance_ns how far another stamp may lie. Throws
///   std::runtime_error if the two are in different frames.
PartsEvaluation evaluateParts(const JointTrack& truth, const std::string& world_frame,
                              const PartsRecord& parts, int64_t tolerance_ns);

}  // namespace markerless_mocap
