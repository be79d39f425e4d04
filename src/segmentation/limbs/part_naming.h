#pragma once

#include <array>
#include <cstddef>

#include "markerless_mocap/products/body_parts.h"
#include "segmentation/limbs/extremity_measures.h"

namespace markerless_mocap {

/// Assignment of extremities to parts.
struct PartNaming {
  std::array<int, kPartCount> extremity;  ///< index by PartLabel; -1: none fits; the torso has none
  /// Mean clipped squared z-score of the assigned parts under the statistics of human bodies;
  /// infinity if no part is assigned.
  double cost;
};

/// Assigns extremities to head, arms and legs by their fullness, their geodesic distances and their
/// heights. This needs no body model, and the person need not be upright. The assignment with the
/// minimum sum of clipped squared z-scores is chosen. A part that is left out costs nothing, and
/// each assigned part gets an allowance. Of the two arms (legs) the first has the smaller index of
/// extremity.
PartNaming assignParts(const ExtremityMeasures& measures);

/// Whether the size of a branch is plausible for a part.
/// \param volume_fraction number of nodes of the branch divided by that of the hull
/// \param thickness mean depth of its nodes under the surface, in cube roots of the hull's volume
bool isPlausible(PartLabel label, double volume_fraction, double thickness);

}  // namespace markerless_mocap
