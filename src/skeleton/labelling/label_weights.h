#pragma once

#include <array>

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
struct ExtremityModel {
  double constant;
  std::array<PiecewiseLinear, kExtremityFeatureCount> curves;
};
extern const std::array<ExtremityModel, 3> kExtremityModels;  ///< of head, hand, foot

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
  kArmsUnlike,      ///< absolute log ratio of the ways from the head to the hands
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
extern const std::array<PiecewiseLinear, kBodyFeatureCount> kBodyCurves;
extern const double kNoBodyLogOdds;  ///< log-odds that no five ends are right

}  // namespace markerless_mocap
