#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/hull/voxel_lattice.h"

namespace markerless_mocap {

/// One-voxel-wide curves in the middle of a body, with the body's topology.
struct CurveSkeleton {
  VoxelLattice lattice;
  std::vector<uint32_t> voxels;  ///< linear indices in the lattice, ascending; 26-connected
};

}  // namespace markerless_mocap
