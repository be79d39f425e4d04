#pragma once

#include <array>

#include "skeleton/graph/tree_graph.h"
#include "skeleton/graph/tree_parts.h"
#include "skeleton/graph/tree_volume.h"
#include "skeleton/labelling/label_choice.h"
#include "skeleton/labelling/left_right.h"

namespace markerless_mocap {

/// Measures of a labelled tree from which the probability of correct labels is estimated. Lengths
/// are fractions of the longest path.
enum ValidityFeature {
  kNamesOdds,    ///< log-odds of ExtremityLabels::probability
  kArmsOffset,   ///< distance by which one arm lies left of the other, see leftOffset()
  kLegsOffset,   ///< the same of the legs; 0 if the feet share an extremity
  kArmsAcross,   ///< cosine between `left` and the direction from arm to arm
  kLegsAgree,    ///< cosine between the forward directions of the two legs
  kFeetForward,  ///< component of a foot along `forward`, divided by its length; the larger of both
                 ///< feet
  kHeadBelow,    ///< height of the highest node above the head's extremity
  kHeadUpright,  ///< cosine between the torso and the direction from hips to head
  kHandNear,     ///< distance from the trunk to the nearer hand
  kSpurLength,   ///< longest branch that belongs to no part
  kShankRadius,  ///< of the thicker shank
  kShorterArm,
  kLongerArm,
  kFeetGap,       ///< straight-line distance between the feet
  kLowFootUp,     ///< height of the lower foot above the lowest node
  kShorterReach,  ///< path length from the head's extremity to the nearer hand
  kArmsUnlike,    ///< absolute log ratio of the path lengths to the hands
  kLegsUnlike,    ///< absolute log ratio of the path lengths to the feet
  kHandRadius,    ///< of the thicker hand
  kFootRadius,
  kHeadRadius,
  kFeetAreOne,  ///< 1: both feet share one extremity
  kValidityFeatureCount
};
using ValidityFeatures = std::array<double, kValidityFeatureCount>;
/// "names_odds", ...
const char* toString(ValidityFeature feature);

/// A body whose extremities are chosen and whose axes are known.
struct LabelledBody {
  const TreeGraph& graph;
  const TreeVolume& volume;
  const LabelChoice& choice;
  const RerootedTree& rerooted;
  const BodyPaths& paths;  ///< none of them empty
  const BodyAxes& axes;
  double labels_probability;
};
ValidityFeatures validityFeatures(const LabelledBody& body);

}  // namespace markerless_mocap
