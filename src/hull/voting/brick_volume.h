#pragma once

#include <vector>

#include "hull/voting/brick_words.h"
#include "markerless_mocap/products/voxel_lattice.h"

namespace markerless_mocap {

/// Number of bricks along the axes.
inline Eigen::Vector3i bricksOf(const VoxelLattice& lattice) {
  return (lattice.size.array() + kBrickSide - 1) / kBrickSide;
}

/// A set of voxels of a lattice: one word per brick, and a map of the bricks that hold voxels.
class BrickVolume {
 public:
  explicit BrickVolume(const VoxelLattice& lattice);

  const Eigen::Vector3i& size() const { return size_; }  ///< bricks
  size_t count() const { return words_.size(); }
  size_t brickAt(int x, int y, int z) const { return (size_t(z) * size_.y() + y) * size_.x() + x; }
  uint64_t word(size_t brick) const { return words_[brick]; }

  void clear();
  /// Two threads may set bricks at the same time if the bricks are not in one group of eight along
  /// x.
  void set(int x, int y, int z, uint64_t word) {
    words_[brickAt(x, y, z)] = word;
    uint8_t& group = groups_[(size_t(z) * size_.y() + y) * groups_per_row_ + x / 8];
    group = uint8_t(word != 0 ? group | 1u << x % 8 : group & ~(1u << x % 8));
  }

  /// Calls visit(x, y, z, brick) for each brick that holds voxels, in the order of bricks.
  template <class Visit>
  void forEachBrick(Visit visit) const {
    for (int z = 0; z < size_.z(); ++z)
      for (int y = 0; y < size_.y(); ++y) {
        const uint8_t* row = &groups_[(size_t(z) * size_.y() + y) * groups_per_row_];
        for (int g = 0; g < groups_per_row_; ++g)
          for (uint32_t group = row[g]; group != 0; group &= group - 1) {
            const int x = g * 8 + __builtin_ctz(group);
            visit(x, y, z, brickAt(x, y, z));
          }
      }
  }

 private:
  Eigen::Vector3i size_;
  int groups_per_row_;
  std::vector<uint64_t> words_;
  std::vector<uint8_t> groups_;  ///< bit x % 8 of a group of eight bricks: the brick holds voxels
};

}  // namespace markerless_mocap
