#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/thinning/bit_volume.h"

namespace markerless_mocap {

/// Fills what is empty inside an object and not 6-connected with the outside.
class CavityFiller {
 public:
  /// Returns the number of voxels filled.
  uint32_t fill(const BitBox& box, BitWords* voxels);

 private:
  void markFlanked(const BitBox& box, const BitWords& voxels);
  void openFromOutside(const BitBox& box, const BitWords& voxels);

  BitWords flanked_;  ///< empty, with an object's voxel somewhere to all six sides
  BitWords before_;
  std::vector<size_t> open_;  ///< bits reached from outside whose neighbours are to be looked at
};

}  // namespace markerless_mocap
