#pragma once

#include <cstddef>
#include <vector>

#include "markerless_mocap/hull/voxel_lattice.h"

namespace markerless_mocap {

/// Calls found(a, b) for all positions a, b of the sorted list `voxels` with voxel b = voxel a +
/// `step` (each coordinate -1, 0 or 1, the linear index grows). One sweep, no dense array.
template <class Found>
void forNeighbors(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels,
                  const Eigen::Vector3i& step, Found found) {
  const int64_t ahead =
      (int64_t(step.z()) * lattice.size.y() + step.y()) * lattice.size.x() + step.x();
  size_t b = 0;
  for (size_t a = 0; a < voxels.size(); ++a) {
    const int64_t wanted = voxels[a] + ahead;
    while (b < voxels.size() && voxels[b] < wanted) ++b;
    if (b == voxels.size()) return;
    // The linear index wraps at the lattice's faces, neighbourhood does not.
    if (voxels[b] == wanted &&
        lattice.coordinates(voxels[b]) == lattice.coordinates(voxels[a]) + step)
      found(a, b);
  }
}

}  // namespace markerless_mocap
