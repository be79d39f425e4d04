#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace markerless_mocap {

/// Regular lattice of cubic voxels with the axes of the world. Voxel (i, j, k) has its centre at
/// origin + pitch * (i + 1/2, j + 1/2, k + 1/2). In the linear index, x varies fastest.
struct VoxelLattice {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< corner with the minimum x, y and z, metres
  double pitch = 0.03;                               ///< metres
  Eigen::Vector3i size = Eigen::Vector3i::Zero();    ///< number of voxels along x, y, z

  uint32_t count() const { return uint32_t(size.x()) * size.y() * size.z(); }
  uint32_t index(int i, int j, int k) const { return (uint32_t(k) * size.y() + j) * size.x() + i; }
  Eigen::Vector3i coordinates(uint32_t index) const {
    return {int(index % size.x()), int(index / size.x() % size.y()),
            int(index / (uint32_t(size.x()) * size.y()))};
  }
  Eigen::Vector3d center(uint32_t index) const {
    return origin + pitch * (coordinates(index).cast<double>().array() + 0.5).matrix();
  }
  bool operator==(const VoxelLattice& o) const;
};

}  // namespace markerless_mocap
