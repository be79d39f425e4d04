#pragma once

#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"
#include "skeleton/thinning/bit_volume.h"

namespace markerless_mocap {

/// The bounding box of a set of voxels of a lattice, as bits. Its rows lie along the axis that
/// needs the fewest words; this is z for a standing person.
class BitVolumeWindow {
 public:
  /// \param voxels linear indices, ascending, at least one
  /// Throws std::invalid_argument on an index beyond the lattice or out of order.
  void load(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels, BitWords* bits);
  /// Linear indices, ascending.
  std::vector<uint32_t> unload(const VoxelLattice& lattice, const BitWords& bits) const;

  const BitBox& box() const { return box_; }

 private:
  /// Voxels of one row of the lattice.
  struct Row {
    size_t begin, end;      ///< in the list of voxels
    Eigen::Vector3i first;  ///< lattice coordinates
  };
  void listRows(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels);
  void place(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels);

  std::vector<Row> rows_;
  BitBox box_;
  Eigen::Vector3i low_ = Eigen::Vector3i::Zero();  ///< first voxel of the box
  int axis_ = 0;                                   ///< axis of the lattice along the rows
};

}  // namespace markerless_mocap
