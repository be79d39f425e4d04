#pragma once

#include <cstdint>

#include "hull/voting/brick_words.h"

namespace markerless_mocap {

/// Sixty-four counters up to 1023, one per voxel of a brick: bit v of plane p is bit p of the
/// counter of voxel v.
class BitSlicedCounter {
 public:
  explicit BitSlicedCounter(uint32_t start) {
    for (int p = 0; p < kPlanes; ++p) planes_[p] = start >> p & 1 ? kAllVoxels : 0;
  }

  void add(uint64_t voxels, uint32_t weight) {
    for (int bit = 0; weight >> bit != 0; ++bit) {
      if ((weight >> bit & 1) == 0) continue;
      uint64_t carry = voxels;
      for (int p = bit; p < kPlanes && carry != 0; ++p) {
        const uint64_t both = planes_[p] & carry;
        planes_[p] ^= carry;
        carry = both;
      }
    }
  }

  /// The voxels whose counter is at least `limit`.
  uint64_t atLeast(uint32_t limit) const {
    uint64_t greater = 0, equal = kAllVoxels;
    for (int p = kPlanes - 1; p >= 0; --p) {
      const uint64_t bound = limit >> p & 1 ? kAllVoxels : 0;
      greater |= equal & planes_[p] & ~bound;
      equal &= ~(planes_[p] ^ bound);
    }
    return greater | equal;
  }

 private:
  static constexpr int kPlanes = 10;
  uint64_t planes_[kPlanes];
};

}  // namespace markerless_mocap
