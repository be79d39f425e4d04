#include "hull/voting/brick_volume.h"

#include <algorithm>

namespace markerless_mocap {

BrickVolume::BrickVolume(const VoxelLattice& lattice)
    : size_(bricksOf(lattice)),
      groups_per_row_((size_.x() + 7) / 8),
      words_(size_t(size_.x()) * size_.y() * size_.z(), 0),
      groups_(size_t(groups_per_row_) * size_.y() * size_.z(), 0) {}

void BrickVolume::clear() {
  forEachBrick([&](int, int, int, size_t brick) { words_[brick] = 0; });
  std::fill(groups_.begin(), groups_.end(), uint8_t(0));
}

}  // namespace markerless_mocap
