#pragma once

#include <map>
#include <string>
#include <vector>

#include "evaluation/label_error.h"

namespace markerless_mocap {

/// What a bag says that the pose tree stage found.
struct TreeRecord {
  std::string world_frame;
  std::vector<int64_t> stamps_ns;  ///< ascending
  std::vector<LabelledExtremities> labels;
  std::vector<std::string> statuses, reasons;
  JointTrack joints;  ///< of the valid instants, by the names of the truth
};

/// Reads /pose_tree; no stamps without that topic. Throws std::runtime_error if the bag cannot be
/// read, std::invalid_argument on a message that is no tree.
TreeRecord readTrees(const std::string& path);

/// Pose trees held against the truth.
struct TreeEvaluation {
  LabelErrors labels;
  std::map<std::string, size_t> status_counts;  ///< of the truth's frames; "missing": nothing said
  std::vector<std::string> reasons;             ///< per frame of the truth; empty when valid
  std::vector<std::string> joints;              ///< joints of the tree by the names of the truth
  std::vector<SummaryStatistics>
      joint_errors_mm;  ///< of each, over the valid frames it is found in
};

/// \param truth with labelTruthNames() and the joints \param tolerance_ns how far another stamp may
///   lie. Throws std::runtime_error if the two are in different frames.
TreeEvaluation evaluateTrees(const JointTrack& truth, const std::string& world_frame,
                             const TreeRecord& trees, int64_t tolerance_ns);

}  // namespace markerless_mocap
