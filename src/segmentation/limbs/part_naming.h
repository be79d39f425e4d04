#pragma once

#include <array>
#include <cstddef>

#include "markerless_mocap/products/body_parts.h"
#include "segmentation/limbs/extremity_measures.h"

namespace markerless_mocap {

/// Which tip is which part's.
struct PartNaming {
  std::array<int, kPartCount> extremity;  ///< by PartLabel, -1 where none fits; the torso has none
  /// Mean clipped squared z-score of what was named, against human bodies; infinity for nothing.
  double cost;
};

/// Names tips by their fullness, the ways between them and their heights, which need no body model
/// and do not insist on an upright person: of all assignments of tips to head, arms and legs the
/// one with the least sum of clipped squared z-scores, where a part left out costs nothing and a
/// part named must pay for itself. Of the two arms (legs) the first has the earlier tip.
PartNaming assignParts(const ExtremityMeasures& measures);

/// Whether a branch has a size that a limb of this name can have.
/// \param volume_fraction nodes of the branch, of the hull's
/// \param thickness mean depth of its nodes under the surface, in cube roots of the hull's volume
bool isPlausible(PartLabel label, double volume_fraction, double thickness);

}  // namespace markerless_mocap
