#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

bool VoxelLattice::operator==(const VoxelLattice& o) const {
  return origin == o.origin && pitch == o.pitch && size == o.size;
}

}  // namespace markerless_mocap
