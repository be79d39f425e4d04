#pragma once

#include "markerless_mocap/options/options.h"
#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

class PartTracker;

/// Settings of the segmentation stage.
struct SegmentationOptions {
  static constexpr const char* kStage = "body_segmentation";
  /// how limbs are found in the eigenmap; merge_tree: by the maxima of the distance from the core;
  /// spline_walk: by splines that grow inwards from the extremities
  std::string branch_method = "merge_tree";
  /// where a branch of spline_walk ends; origin: near the origin of the eigenmap (Hsiao 2008), with
  /// a shrink_weight of about 100; outliers: where many nodes are far from the spline (Sundaresan
  /// and Chellappa 2008), with shrink_weight 0
  std::string walk_stop = "origin";
  /// dimensions of the eigenmap; 0: 10 for merge_tree, 6 for spline_walk
  int modes = 0;
  /// weight the edges between voxels by the cameras' votes that neighbours have the same colour
  bool use_color_votes = false;
  /// weight added to the edges in the thick core of the body, which draws the torso together
  double shrink_weight = 0.0;
  /// a hull is not a person when the mean squared z-score of its limbs' measures is above this
  double max_cost = 2.0;
  /// volume of the smallest hull of a person, litres
  double min_litres = 15.0;
  /// volume of the largest hull of a person, litres
  double max_litres = 200.0;

  void visit(OptionVisitor& v);
  void validate() const;
};

/// Segments a hull into six body parts in its Laplacian eigenspace (Hsiao 2008, 3.1.4) and fits a
/// curve to each part (3.1.5.2).
class BodySegmenter {
 public:
  explicit BodySegmenter(const SegmentationOptions& options);
  /// Does not throw on a bad hull; status and reason say what is wrong. kOk: all six parts are
  /// found, the arms are whole, and legs that touch are divided equally. kPartial: torso, head, one
  /// leg and one more limb are found; the reason names the parts that are not seen, whose voxels
  /// are labelled torso, and those that are merged with others.
  BodyParts segment(const VisualHull& hull) const;

  /// The same for a frame of a sequence. Arms and legs keep their numbers from frame to frame. A
  /// limb that is not seen for a short time keeps its label on the voxels where it was. Status and
  /// curves depend on this frame alone.
  /// \param tracker state of the previous frames; this frame is added if the graph of a body is
  ///   found; null: none
  BodyParts segment(const VisualHull& hull, int64_t stamp_ns, PartTracker* tracker) const;

 private:
  SegmentationOptions options_;
};

}  // namespace markerless_mocap
