#pragma once

#include "markerless_mocap/options/options.h"
#include "markerless_mocap/products/body_parts.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

class PartTracker;

/// Weights of edges by colour votes (Hsiao 2008, Eq. 3-15).
struct ColorBonus {
  /// a of Eq. 3-15: added to an edge's weight of 1 when all cameras that vote find one colour
  double all = 1.0;
  /// b of Eq. 3-15: added when most of them do
  double most = 0.5;
  /// c of Eq. 3-15: added when few of them do; every weight stays above 0
  double few = -0.9;
  /// th_1 of Eq. 3-15, as a fraction of the cameras that vote: from here on, most do
  double most_from = 0.5;
  /// th_3 of Eq. 3-15, as a fraction of the cameras that vote: below this, few do
  double few_below = 0.5;

  void visit(OptionVisitor& v);
};

/// Settings of the branch method spline_walk (Hsiao 2008, 3.1.4).
struct SplineWalkOptions {
  /// P: number of nodes that a branch begins with, as a fraction of all nodes
  double initial_nodes = 0.02;
  /// N: number of nodes that a step adds, as a fraction of all nodes
  double step_nodes = 0.005;
  /// a new principal direction is used where it turns by more than this, rad
  double turn_angle = 0.35;
  /// a branch ends this near the origin, as a fraction of the largest distance of a node from it
  double stop_radius = 0.08;
  /// OT_1: a branch ends with more outliers than this, as a fraction of all nodes
  double max_outliers = 0.001;
  /// OT_2: a node this far from the spline is an outlier, as a fraction of its start's distance
  double outlier_distance = 0.007;
  /// nodes this near the spline belong to the branch, as a fraction of its start's distance
  double tube_radius = 0.1;

  void visit(OptionVisitor& v);
};

/// Settings of the segmentation stage.
struct SegmentationOptions {
  static constexpr const char* kStage = "body_segmentation";
  /// how limbs are found in the eigenmap; merge_tree: by the maxima of the distance from the core;
  /// spline_walk: by splines that grow inwards from the extremities
  std::string branch_method = "merge_tree";
  /// where a branch of spline_walk ends; origin: near the origin of the eigenmap (Hsiao 2008), with
  /// a shrink_weight; outliers: where many nodes are far from the spline (Sundaresan
  /// and Chellappa 2008), with shrink_weight 0
  std::string walk_stop = "origin";
  /// dimensions of the eigenmap; 0: 10 for merge_tree, 6 for spline_walk
  int modes = 0;
  /// weight the edges between voxels by the cameras' votes that neighbours have the same colour
  bool use_color_votes = false;
  /// how votes weight edges
  ColorBonus color_bonus;
  /// weight added to the edges in the thick core of the body, which draws the torso together
  double shrink_weight = 0.0;
  /// which nodes are the thick core; 0: those deepest under the surface; else those with at least
  /// this fraction of the largest degree (Hsiao 2008, 3.1.4.2 A-2: 1)
  double shrink_degree = 0.0;
  /// the method spline_walk
  SplineWalkOptions spline_walk;
  /// modes of a part's own eigenmap that give its curve's site values; 0: 10 for the torso, 3 for
  /// other parts; 1: the Fiedler vector alone (Hsiao 2008, 3.1.5.2)
  int site_modes = 0;
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
