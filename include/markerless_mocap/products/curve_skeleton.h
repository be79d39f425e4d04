#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// One-voxel-wide curves in the middle of a body, with the body's topology.
struct CurveSkeleton {
  VoxelLattice lattice;
  std::vector<uint32_t> voxels;  ///< linear indices in the lattice, ascending; 26-connected

  uint32_t components_dropped = 0;  ///< 26-components of the hull that are not the body
  uint32_t voxels_dropped = 0;      ///< in these
  uint32_t voxels_filled = 0;       ///< in cavities of the body, filled before thinning
};

}  // namespace markerless_mocap
