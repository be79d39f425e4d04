#pragma once

#include <array>
#include <string>

#include "skeleton/labelling/piecewise_linear.h"

namespace markerless_mocap {

/// What an end alone tells about what it is. Lengths are shares of the longest path.
enum ExtremityFeature {
  kEndUp,         ///< height of the tip above the lowest node
  kEndDown,       ///< height of the highest node above the tip
  kEndDirection,  ///< upward share of the direction in which it ends
  kEndExtent,     ///< from the node to the surface
  kEndTipRadius,
  kEndLimbRadius,
  kEndBranch,  ///< to the nearest branching
  kEndCut,     ///< 1: made by opening a loop
  kEndReach,   ///< longest way to another end
  kExtremityFeatureCount
};
/// "end_up", ...
const char* toString(ExtremityFeature feature);

/// What five ends together tell about whether they are a body's. Lengths are shares of the mean way
/// from the head to the feet. "Way" is the shortest one over all loops, "tree way" that along the
/// tree of shortest paths from the root.
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
  kFeetUnlike,  ///< absolute log ratio of the ways from the head to the feet
  kFootFootGap,
  kHandHandGap,     ///< straight distances
  kNeckLength,      ///< what the ways to the hands share
  kTorsoLength,     ///< what the ways to the feet share beyond the neck
  kHandsUnlike,     ///< absolute log ratio of the ways from the head to the hands
  kHeadUp,          ///< above the lower foot
  kFootUp,          ///< above the lowest node
  kFeetUnevenness,  ///< difference of their heights
  kHandUp,          ///< above the lower foot
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
  kFeetTogether,  ///< 1: both feet share one end
  kArmPath,       ///< of a hand to the nearest place between the head and a foot
  kArmTreePath,
  kHeadHandGap,
  kHandFootGap,
  kBodyFeatureCount
};
/// "head_hand_path", ...
const char* toString(BodyFeature feature);

/// Log-odds that an end is a head (a hand, a foot) against that it is nothing.
struct ExtremityModel {
  double constant = 0.0;
  std::array<PiecewiseLinear, kExtremityFeatureCount> curves;
};

/// Parts of the log-odds that five ends are a body's.
struct BodyCurves {
  std::array<PiecewiseLinear, kBodyFeatureCount> curves;
  double operator()(BodyFeature feature, double x) const { return curves[size_t(feature)](x); }
};

/// The numbers by which the ends of a skeleton are named.
struct ExtremityLabelModel {
  std::array<ExtremityModel, 3> extremities;  ///< head, hand, foot
  BodyCurves body;
  double no_body_log_odds = 0.0;  ///< that no five ends are right

  /// Reads models/pose_tree_extremities.yaml. Throws as PoseTreeModel::fromYaml().
  static ExtremityLabelModel fromYaml(const std::string& yaml, const std::string& where);
};

}  // namespace markerless_mocap
