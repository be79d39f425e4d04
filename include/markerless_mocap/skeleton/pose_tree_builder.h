#pragma once

#include <memory>

#include "markerless_mocap/products/curve_skeleton.h"
#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/skeleton/pose_tree_model.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"

namespace markerless_mocap {

/// Thins a hull to its curve skeleton and labels that as a body (Bakken & Hilton 2012, 3.3). Every
/// frame stands alone unless `follow_labels` is on. Never throws on a bad hull: the status says
/// what is wrong. Not for two threads at once.
class PoseTreeBuilder {
 public:
  /// Throws std::invalid_argument on options out of range.
  explicit PoseTreeBuilder(const PoseTreeOptions& options,
                           const PoseTreeModel& model = PoseTreeModel::standard());
  ~PoseTreeBuilder();
  PoseTreeBuilder(PoseTreeBuilder&&) noexcept;
  PoseTreeBuilder& operator=(PoseTreeBuilder&&) noexcept;

  PoseTree build(const VisualHull& hull);
  /// Of a skeleton that somebody else made of the hull.
  PoseTree build(const VisualHull& hull, const CurveSkeleton& skeleton);
  /// Forgets the last valid frame.
  void reset();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace markerless_mocap
