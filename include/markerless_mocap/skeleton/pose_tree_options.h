#pragma once

#include <string>

#include "markerless_mocap/options/options.h"
#include "markerless_mocap/skeleton/limb_ratios.h"

namespace markerless_mocap {

/// Settings of the pose tree stage. config/as_published/bakken.yaml has those of Bakken and Hilton
/// 2012, whose equations and algorithms are named here.
struct PoseTreeOptions {
  static constexpr const char* kStage = "pose_tree";
  /// how extremities are labelled; template: by the lengths of a body between them, with loops
  /// opened where these fit best; ranking: by the rank of the origin (Bakken and Hilton 2012)
  std::string labelling = "template";
  /// how limbs are labelled left or right; offsets: by how far to the left thighs and upper arms
  /// are; angles: by the angles of hips and shoulders (Bakken and Hilton 2012)
  std::string side_rule = "offsets";
  /// a curve of the skeleton is kept if it stands out of the body by this length after thinning, m;
  /// curves along limbs are shorter by it
  double persistence = 0.02;
  /// paths to the top-most voxel; shortest: by length; breadth_first: by number of voxels
  /// (Algorithm 2)
  std::string tree_paths = "shortest";
  /// standard deviation of the smoothing along the skeleton, m; 0: none
  double smoothing = 0.03;
  /// where an extremity is; surface: a learned distance before the hull's surface; leaf: at the
  /// leaf of the tree (Bakken and Hilton 2012)
  std::string extremities = "surface";
  /// ranking: branches shorter than this fraction of the longest path are spurs; an arm without its
  /// shoulder is 0.274
  double prune_ratio = 0.08;
  /// ranking: what the second factor of a leg's rank (Eq. 2) compares with its way from the
  /// branching to the origin; torso: the torso's length; printed: the leg's length
  std::string leg_rank = "torso";
  /// ranking: divisor of the squared difference of the origin's degree from four (Eq. 1)
  double degree_spread = 3.0;
  /// ranking: unit of the ways that shorten arms and neck (Eq. 3 and 4), m
  double shortening_unit = 0.015625;
  /// ranking: a frame is invalid when the rank of its origin is below this
  double min_rank = 0.0;
  /// template: a frame is invalid when the estimated probability of correct labels and sides is
  /// below this
  double min_validity = 0.9;
  /// ranking: label extremities by the nearest ones of the last valid frame
  bool follow_labels = false;
  /// of the path that both legs share, what is beyond this multiple of the torso's length belongs
  /// to the legs
  double max_torso = 1.6;
  /// sine of the bend below which a knee or an ankle does not tell the forward direction (Algorithm
  /// 5)
  double min_bend = 0.14;
  /// the foot of a leg that is shorter than the other one by this many foot lengths is not used
  /// (Algorithm 5)
  double short_leg = 2.0;
  /// ranking and sides: lengths of limbs as fractions of the longest path (Table 1)
  LimbRatios limb_ratios;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
