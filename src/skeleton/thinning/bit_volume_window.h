#pragma once

#include <vector>

#include "markerless_mocap/products/voxel_lattice.h"
#include "skeleton/thinning/bit_volume.h"

namespace markerless_mocap {

/// The box of a lattice that holds a set of voxels, as bits. Its rows lie along the axis of the
/// lattice that takes the fewest words, for a standing person z.
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
    size_t begin, end;      ///< in the list
    Eigen::Vector3i first;  ///< coordinates
  };
  void listRows(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels);
  void place(const VoxelLattice& lattice, const std::vector<uint32_t>& voxels);

  std::vector<Row> rows_;
  BitBox box_;
  Eigen::Vector3i low_ = Eigen::Vector3i::Zero();  ///< first voxel of the box
  int axis_ = 0;                                   ///< of the lattice, along the rows
};

}  // namespace markerless_mocap
