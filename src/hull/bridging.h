#pragma once

#include <vector>

#include "markerless_mocap/hull/voxel_lattice.h"

namespace markerless_mocap {

/// Joins pieces of one body that a lost vote has cut apart. Each further piece of at least
/// `least_voxels` is joined to the largest one by the voxels of `loose` on the shortest ways
/// between the two, if any are shorter than 0.5 m. \param loose sorted superset of all pieces,
/// carved with more missing votes \param pieces largest first, each sorted; so is the result
std::vector<std::vector<uint32_t>> bridgePieces(const VoxelLattice& lattice,
                                                const std::vector<uint32_t>& loose,
                                                std::vector<std::vector<uint32_t>> pieces,
                                                size_t least_voxels);

}  // namespace markerless_mocap
