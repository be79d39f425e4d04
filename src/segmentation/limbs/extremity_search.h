#pragma once

#include <cstdint>
#include <vector>

#include "segmentation/voxel_graph.h"

namespace markerless_mocap {

/// Finds the extremities of limbs: the most persistent maxima of the distance from the core in the
/// eigenmap. Large hulls are embedded in blocks of voxels; the extremity is then the voxel of the
/// block that is furthest from the core's centre.
/// \param core nodes of the thick core, not empty
/// \param modes number of modes of the eigenmap
/// \param count maximum number of extremities
/// \return up to `count` nodes, the most persistent first
std::vector<uint32_t> findExtremities(const VoxelGraph& voxels, const std::vector<uint32_t>& core,
                                      int modes, int count);

}  // namespace markerless_mocap
