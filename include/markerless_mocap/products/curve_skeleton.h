#pragma once

#include <cstdint>
#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// Curve skeleton of a hull: curves one voxel wide along the middle of the body, with the body's
/// topology.
struct CurveSkeleton {
  VoxelLattice lattice;
  std::vector<uint32_t> voxels;  ///< linear indices in the lattice, ascending; 26-connected

  uint32_t components_dropped = 0;  ///< 26-connected components of the hull that were not kept
  uint32_t voxels_dropped = 0;      ///< voxels in dropped components
  uint32_t voxels_filled = 0;       ///< voxels of cavities, filled before thinning
};

}  // namespace markerless_mocap
