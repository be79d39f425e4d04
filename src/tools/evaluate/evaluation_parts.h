#pragma once

#include <map>
#include <string>
#include <vector>

#include "evaluation/part_error.h"

namespace markerless_mocap {

/// Results of the segmentation stage in a bag.
struct PartsRecord {
  std::string world_frame;
  std::vector<int64_t> stamps_ns;  ///< ascending
  std::vector<SegmentedHull> hulls;
  std::vector<std::string> statuses, reasons;
};

/// Reads /segmentation/points, /segmentation/parts and /hull/grid; no stamps if they are missing.
/// Throws std::runtime_error if the bag cannot be read, std::invalid_argument on an invalid
/// message.
PartsRecord readParts(const std::string& path);

/// Comparison of segmented hulls with the ground truth.
struct PartsEvaluation {
  PartErrors errors;
  std::map<std::string, size_t> status_counts;  ///< over the frames of the ground truth; "missing":
                                                ///< no result
  std::vector<std::string> reasons;             ///< per frame of the ground truth; empty if valid
};

/// \param truth with partTruthNames()
/// \param tolerance_ns maximum difference of a stamp
/// Throws std::runtime_error if the two are in different frames.
PartsEvaluation evaluateParts(const JointTrack& truth, const std::string& world_frame,
                              const PartsRecord& parts, int64_t tolerance_ns);

}  // namespace markerless_mocap
