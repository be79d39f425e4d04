#pragma once

#include <cstdint>
#include <vector>

#include "skeleton/thinning/bit_volume.h"

namespace markerless_mocap {

struct DroppedComponents {
  uint32_t components = 0;
  uint32_t voxels = 0;
};

/// 26-connected components of a bit volume, by union-find over runs of voxels along x.
class LargestComponent {
 public:
  /// Clears all voxels but those of the largest component; of components of equal size the first in
  /// the order of rows is kept.
  DroppedComponents keep(const BitBox& box, BitWords* voxels);

 private:
  struct Run {
    int row;            ///< index of the padded row
    int first, behind;  ///< bits of the row; `behind` is exclusive
    uint32_t parent;
    uint32_t voxels;  ///< at a root: number of voxels of the component
  };
  void listRuns(const BitBox& box, const BitWords& voxels);
  void joinRows(int row, int earlier_row);
  void join(uint32_t a, uint32_t b);
  uint32_t root(uint32_t run);

  std::vector<Run> runs_;
  std::vector<uint32_t> first_run_;  ///< per padded row, and one at the end
};

}  // namespace markerless_mocap
