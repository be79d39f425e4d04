#pragma once

#include <vector>

#include "character/body/surface_net.h"
#include "character/character.h"
#include "character/clothes/dressed_shape.h"

namespace markerless_mocap {

/// How bones carry a dressed body: shares by place around the joints, then evened out over the
/// surface. \param layers of each vertex
std::vector<VertexWeights> skinWeights(const HumanSkeleton& skeleton, const Surface& surface,
                                       const std::vector<Layer>& layers);

}  // namespace markerless_mocap
