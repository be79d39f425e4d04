#pragma once

#include <map>
#include <string>
#include <vector>

#include "evaluation/label_error.h"

namespace markerless_mocap {

/// Results of the pose tree stage in a bag.
struct TreeRecord {
  std::string world_frame;
  std::vector<int64_t> stamps_ns;  ///< ascending
  std::vector<LabelledExtremities> labels;
  std::vector<std::string> statuses, reasons;
  JointTrack joints;  ///< of the valid trees, with the joint names of the ground truth
};

/// Reads /pose_tree; no stamps without that topic. Throws std::runtime_error if the bag cannot be
/// read, std::invalid_argument on an invalid message.
TreeRecord readTrees(const std::string& path);

/// Comparison of pose trees with the ground truth.
struct TreeEvaluation {
  LabelErrors labels;
  std::map<std::string, size_t> status_counts;  ///< over the frames of the ground truth; "missing":
                                                ///< no result
  std::vector<std::string> reasons;             ///< per frame of the ground truth; empty if valid
  std::vector<std::string> joints;  ///< joints of the tree, with the names of the ground truth
  /// Per joint, over the valid frames that contain it.
  std::vector<SummaryStatistics> joint_errors_mm;
};

/// \param truth with labelTruthNames() and the joints
/// \param tolerance_ns maximum difference of a stamp
/// Throws std::runtime_error if the two are in different frames.
TreeEvaluation evaluateTrees(const JointTrack& truth, const std::string& world_frame,
                             const TreeRecord& trees, int64_t tolerance_ns);

}  // namespace markerless_mocap
