#pragma once

#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the pose tree stage.
struct PoseTreeOptions {
  static constexpr const char* kStage = "pose_tree";
  std::string labelling = "template";
  std::string side_rule = "offsets";
  double prune_ratio = 0.08;
  double min_rank = 0.0;
  double min_validity = 0.9;
  bool follow_labels = false;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
