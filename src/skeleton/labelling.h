#pragma once

#include <optional>
#include <string>

#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "skeleton/labelling/label_doubts.h"
#include "skeleton/labelling/label_ranking.h"
#include "skeleton/labelling/left_right.h"
#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_parts.h"
#include "skeleton/graph/tree_volume.h"

namespace markerless_mocap {

/// Of the curves of the skeleton that is labelled, metres (Thinner): feet that touch stand out
/// little.
constexpr double kTreePersistence = 0.02;

/// One frame on its way to a pose tree.
class Labelling {
 public:
  /// Keeps references to the options and the hull.
  Labelling(const PoseTreeOptions& options, const VisualHull& hull, const CurveSkeleton& skeleton);

  /// \param last ends to follow \param now set to the ends if the tree is valid
  PoseTree run(const LastEnds& last, LastEnds* now);

  /// What the validity was told by; nothing where the labelling did not come so far.
  const std::optional<LabelDoubts>& doubts() const { return doubts_; }
  const TreeGraph& graph() const { return graph_; }
  const TreeVolume& volume() const { return volume_; }

 private:
  PoseTree& refuse(TreeStatus status, const std::string& reason) {
    tree_.status = status;
    tree_.reason = reason;
    return tree_;
  }
  bool feetTogether() const { return choice_.ends[3] == choice_.ends[4]; }
  void choose(const LastEnds& last);
  void plant();
  void placeTips();
  void tellSides();
  void nameSides();
  void swapSides(size_t first_tip, TreePart left, TreePart right);
  void judge();

  const PoseTreeOptions& options_;
  const VisualHull& hull_;
  TreeVolume volume_;
  TreeGraph graph_;
  LabelChoice choice_;
  double names_probability_ = 0.0;
  PlantedTree planted_;
  BodyPaths body_;
  BodyAxes axes_;
  bool torso_ = false;
  std::optional<LabelDoubts> doubts_;
  PoseTree tree_;
};

}  // namespace markerless_mocap
