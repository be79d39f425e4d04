#pragma once

#include <vector>

#include "character/body/surface_net.h"
#include "character/character.h"
#include "character/clothes/dressed_shape.h"

namespace markerless_mocap {

/// Skinning weights of a dressed body: computed from the position relative to the joints, then
/// smoothed over the surface.
/// \param layers per vertex
std::vector<VertexWeights> skinWeights(const HumanSkeleton& skeleton, const Surface& surface,
                                       const std::vector<Layer>& layers);

/// The four largest weights of bones, scaled to a sum of 1; of equal ones the first.
VertexWeights fourLargest(const PerBone<double>& weights);

}  // namespace markerless_mocap
