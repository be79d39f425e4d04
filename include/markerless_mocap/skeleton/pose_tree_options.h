#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the pose tree stage.
struct PoseTreeOptions {
  static constexpr const char* kStage = "pose_tree";
  /// how extremities are labelled; template: by the lengths of a body between them, with loops
  /// opened where these fit best; ranking: by the rank of the origin (Bakken and Hilton 2012)
  std::string labelling = "template";
  /// how limbs are labelled left or right; offsets: by how far to the left thighs and upper arms
  /// are; angles: by the angles of hips and shoulders (Bakken and Hilton 2012)
  std::string side_rule = "offsets";
  /// ranking: branches shorter than this fraction of the longest path are spurs; 0.274 in the paper
  double prune_ratio = 0.08;
  /// ranking: a frame is invalid when the rank of its origin is below this
  double min_rank = 0.0;
  /// template: a frame is invalid when the estimated probability of correct labels and sides is
  /// below this
  double min_validity = 0.9;
  /// ranking: label extremities by the nearest ones of the last valid frame
  bool follow_labels = false;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
