#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/skeleton/pose_tree_model.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_parts.h"
#include "skeleton/graph/tree_volume.h"
#include "skeleton/labelling/label_ranking.h"
#include "skeleton/labelling/left_right.h"
#include "skeleton/labelling/validity_features.h"

namespace markerless_mocap {

/// Labelling of one frame.
class Labelling {
 public:
  /// Keeps references to the options, the model and the hull.
  Labelling(const PoseTreeOptions& options, const PoseTreeModel& model, const VisualHull& hull,
            const CurveSkeleton& skeleton);

  /// \param last extremities of the last valid frame
  /// \param now output, the extremities if the tree is valid
  PoseTree run(const PreviousExtremities& last, PreviousExtremities* now);

  /// Inputs of the validity estimate; empty if the labelling was rejected earlier.
  const std::optional<ValidityFeatures>& features() const { return validity_features_; }
  const TreeGraph& graph() const { return graph_; }
  const TreeVolume& volume() const { return volume_; }
  const LabelChoice& choice() const { return choice_; }

 private:
  PoseTree& reject(TreeStatus status, const std::string& reason) {
    tree_.status = status;
    tree_.reason = reason;
    return tree_;
  }
  bool feetTogether() const { return choice_.extremities[3] == choice_.extremities[4]; }
  void choose(const PreviousExtremities& last);
  void reroot();
  void placeExtremities();
  void estimateBodyAxes();
  void assignSides();
  void swapSides(size_t first_extremity, TreePart left, TreePart right);
  void assessValidity();

  const PoseTreeOptions& options_;
  const PoseTreeModel& model_;
  const VisualHull& hull_;
  TreeVolume volume_;
  TreeGraph graph_;
  LabelChoice choice_;
  double labels_probability_ = 0.0;
  RerootedTree rerooted_;
  BodyPaths body_;
  BodyAxes axes_;
  bool torso_ = false;
  std::optional<ValidityFeatures> validity_features_;
  PoseTree tree_;
};

}  // namespace markerless_mocap
