#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/thinning/bit_volume.h"

namespace markerless_mocap {

/// Fills the cavities of an object: empty voxels that are not 6-connected with the outside.
class CavityFiller {
 public:
  /// Returns the number of voxels filled.
  uint32_t fill(const BitBox& box, BitWords* voxels);

 private:
  void markFlanked(const BitBox& box, const BitWords& voxels);
  void openFromOutside(const BitBox& box, const BitWords& voxels);

  BitWords flanked_;  ///< empty voxels with a voxel of the object somewhere in all six directions
  BitWords before_;
  std::vector<size_t> open_;  ///< bits reached from outside whose neighbours are to be visited
};

}  // namespace markerless_mocap
