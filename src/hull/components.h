#pragma once

#include <vector>

#include "markerless_mocap/hull/voxel_lattice.h"

namespace markerless_mocap {

/// 26-connected components of a sorted list of voxels; largest first, equal ones by their first
/// voxel; each sorted.
std::vector<std::vector<uint32_t>> connectedComponents(const VoxelLattice& lattice,
                                                       const std::vector<uint32_t>& voxels);

}  // namespace markerless_mocap
