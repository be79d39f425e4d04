#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "markerless_mocap/products/curve_skeleton.h"

namespace markerless_mocap {

/// Maps voxels of a skeleton to nodes. A hash table, as a skeleton has few voxels in its lattice.
class TreeVoxels {
 public:
  TreeVoxels(const CurveSkeleton& skeleton, const std::vector<Eigen::Vector3i>& cells)
      : size_(skeleton.lattice.size) {
    size_t slots = 64;
    while (slots < 4 * cells.size()) slots *= 2;
    mask_ = slots - 1;
    keys_.assign(slots, kEmpty);
    nodes_.resize(slots);
    for (size_t node = 0; node < cells.size(); ++node) {
      const uint64_t key = keyOf(cells[node]);
      size_t slot = slotOf(key);
      while (keys_[slot] != kEmpty) slot = (slot + 1) & mask_;
      keys_[slot] = key;
      nodes_[slot] = int32_t(node);
    }
  }

  /// The node at a voxel; -1: none.
  int32_t nodeAt(const Eigen::Vector3i& cell) const {
    const uint64_t key = keyOf(cell);
    for (size_t slot = slotOf(key); keys_[slot] != kEmpty; slot = (slot + 1) & mask_) {
      if (keys_[slot] == key) return nodes_[slot];
    }
    return -1;
  }

 private:
  static constexpr uint64_t kEmpty = ~uint64_t(0);

  /// Voxels up to one beyond the lattice on each side have keys of their own.
  uint64_t keyOf(const Eigen::Vector3i& cell) const {
    return (uint64_t(cell.z() + 1) * uint64_t(size_.y() + 2) + uint64_t(cell.y() + 1)) *
               uint64_t(size_.x() + 2) +
           uint64_t(cell.x() + 1);
  }
  size_t slotOf(uint64_t key) const { return size_t((key * 0x9E3779B97F4A7C15ull) >> 40) & mask_; }

  Eigen::Vector3i size_;
  size_t mask_ = 0;
  std::vector<uint64_t> keys_;
  std::vector<int32_t> nodes_;
};

}  // namespace markerless_mocap
