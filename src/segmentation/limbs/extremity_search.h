#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Tips of limbs: the most persistent maxima of the distance from the core in the eigenmap. Large
/// hulls are embedded by blocks of their voxels, of which a tip is that voxel farthest from the
/// core's middle.
/// \param core nodes of the thick core, not empty
/// \param modes of the eigenmap
/// \param count of tips wanted
/// \return at most so many nodes, the most persistent first
std::vector<uint32_t> findExtremities(const VoxelGraph& voxels, const std::vector<uint32_t>& core,
                                      int modes, int count);

}  // namespace markerless_mocap
