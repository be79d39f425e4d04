#pragma once

#include <array>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_parts.h"
#include "skeleton/graph/tree_volume.h"
#include "skeleton/labelling/label_choice.h"
#include "skeleton/labelling/left_right.h"

namespace markerless_mocap {

/// What a labelled tree tells about whether it is labelled right. Lengths are shares of the longest
/// path unless told otherwise.
enum ValidityFeature {
  kNamesOdds,    ///< log-odds of the model of the ends, see ExtremityLabels
  kArmsOffset,   ///< how far one lies left of the other, see leftOffset()
  kLegsOffset,   ///< 0 with feet together
  kArmsAcross,   ///< cosine between left and the way from arm to arm
  kLegsAgree,    ///< cosine between what the two legs say about forward
  kFeetForward,  ///< way of a foot in its length along forward, of the less turned one
  kHeadBelow,    ///< of the head's end below the highest node
  kHeadUpright,  ///< cosine between torso and the way from hips to head
  kHandNear,     ///< from the trunk to the nearer hand
  kSpurLength,   ///< longest branch that no part claims
  kShankRadius,  ///< of the thicker one
  kShorterArm,
  kLongerArm,
  kFeetGap,       ///< straight
  kLowFootUp,     ///< of the lower foot above the lowest node
  kShorterReach,  ///< way from the head's end to the nearer hand
  kArmsUnlike,    ///< absolute log ratio of these ways
  kLegsUnlike,    ///< of the ways to the feet
  kHandRadius,    ///< of the thicker hand
  kFootRadius,
  kHeadRadius,
  kFeetAreOne,  ///< 1: both feet share one end
  kValidityFeatureCount
};
using ValidityFeatures = std::array<double, kValidityFeatureCount>;
/// "names_odds", ...
const char* toString(ValidityFeature feature);

/// A body whose ends are chosen and whose axes are known.
struct LabelledBody {
  const TreeGraph& graph;
  const TreeVolume& volume;
  const LabelChoice& choice;
  const RerootedTree& rerooted;
  const BodyPaths& paths;  ///< none empty
  const BodyAxes& axes;
  double names_probability;
};
ValidityFeatures validityFeatures(const LabelledBody& body);

}  // namespace markerless_mocap
