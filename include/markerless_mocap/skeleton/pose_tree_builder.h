#pragma once

#include <memory>

#include "markerless_mocap/products/curve_skeleton.h"
#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/products/visual_hull.h"
#include "markerless_mocap/skeleton/pose_tree_model.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"

namespace markerless_mocap {

/// Thins a hull to its curve skeleton and labels the skeleton as a body (Bakken & Hilton 2012,
/// 3.3). Frames are independent of each other unless `follow_labels` is on. Does not throw on a bad
/// hull; status and reason say what is wrong. Not thread-safe.
class PoseTreeBuilder {
 public:
  /// Throws std::invalid_argument on options out of range.
  explicit PoseTreeBuilder(const PoseTreeOptions& options,
                           const PoseTreeModel& model = PoseTreeModel::standard());
  ~PoseTreeBuilder();
  PoseTreeBuilder(PoseTreeBuilder&&) noexcept;
  PoseTreeBuilder& operator=(PoseTreeBuilder&&) noexcept;

  PoseTree build(const VisualHull& hull);
  /// Labels a given skeleton of the hull.
  PoseTree build(const VisualHull& hull, const CurveSkeleton& skeleton);
  /// Discards the last valid frame.
  void reset();

 private:
  class State;
  std::unique_ptr<State> state_;
};

}  // namespace markerless_mocap
