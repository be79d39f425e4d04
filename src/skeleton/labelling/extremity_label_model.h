#pragma once

#include <array>
#include <string>

#include "skeleton/labelling/piecewise_linear.h"

namespace markerless_mocap {

/// Measures of a single end. Lengths are fractions of the longest path.
enum ExtremityFeature {
  kEndUp,         ///< height of the end above the lowest node
  kEndDown,       ///< height of the highest node above the end
  kEndDirection,  ///< upward component of its direction
  kEndExtent,     ///< distance from the node to the surface
  kEndTipRadius,
  kEndLimbRadius,
  kEndBranch,  ///< path length to the nearest branching
  kEndCut,     ///< 1: results from opening a loop
  kEndReach,   ///< longest path to another end
  kExtremityFeatureCount
};
/// "end_up", ...
const char* toString(ExtremityFeature feature);

/// Measures of five ends together. Lengths are fractions of the mean path length from the head to
/// the feet. A path is the shortest one with all loop edges; a tree path is along the tree of
/// shortest paths from the root.
enum BodyFeature {
  kHeadHandPath,
  kHeadHandTreePath,
  kHandHandPath,
  kHandHandTreePath,
  kHandFootPath,
  kHandFootTreePath,
  kFootFootPath,
  kFootFootTreePath,
  kHeadFeetMetres,
  kFeetUnlike,  ///< absolute log ratio of the path lengths from the head to the feet
  kFootFootGap,
  kHandHandGap,     ///< straight-line distance, as for all gaps
  kNeckLength,      ///< length of the common part of the paths to the hands
  kTorsoLength,     ///< length of the common part of the paths to the feet beyond the neck
  kHandsUnlike,     ///< absolute log ratio of the path lengths from the head to the hands
  kHeadUp,          ///< height above the lower foot
  kFootUp,          ///< above the lowest node
  kFeetUnevenness,  ///< difference of the heights of the feet
  kHandUp,          ///< height above the lower foot
  kHeadTipRadius,
  kHeadLimbRadius,
  kHandTipRadius,
  kHandLimbRadius,
  kFootTipRadius,
  kFootLimbRadius,
  kHeadBranch,
  kHandBranch,
  kFootBranch,
  kHeadCut,
  kHandCut,
  kFootCut,
  kHeadExtent,
  kHandExtent,
  kFootExtent,
  kHeadDirection,
  kHandDirection,
  kFootDirection,
  kFeetTogether,  ///< 1: both feet share one extremity
  kArmPath,  ///< path length from a hand to the nearest node of the path from the head to a foot
  kArmTreePath,
  kHeadHandGap,
  kHandFootGap,
  kBodyFeatureCount
};
/// "head_hand_path", ...
const char* toString(BodyFeature feature);

/// Log-odds that an end is a head (a hand, a foot) against no extremity.
struct ExtremityModel {
  double constant = 0.0;
  std::array<PiecewiseLinear, kExtremityFeatureCount> curves;
};

/// Terms of the log-odds that five ends are the extremities of a body.
struct BodyCurves {
  std::array<PiecewiseLinear, kBodyFeatureCount> curves;
  double operator()(BodyFeature feature, double x) const { return curves[size_t(feature)](x); }
};

/// The learned model of the labels of extremities.
struct ExtremityLabelModel {
  std::array<ExtremityModel, 3> extremities;  ///< head, hand, foot
  BodyCurves body;
  double no_body_log_odds = 0.0;  ///< that no choice of five ends is correct

  /// Reads models/pose_tree_extremities.yaml. Throws as PoseTreeModel::fromYaml().
  static ExtremityLabelModel fromYaml(const std::string& yaml, const std::string& where);
};

}  // namespace markerless_mocap
