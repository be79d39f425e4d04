#include "skeleton/thinning/simple_point.h"
#include "skeleton/thinning/thinning_scheme.h"

namespace markerless_mocap {

bool SideThinning::removable(size_t bit) const {
  const uint32_t around = neighborhood(*box_, object_->data(), bit) & ~kCenterBit;
  const bool end = (around & (around - 1)) == 0;
  return SimplePointTable::shared()(around) && !(end && testBit(*kept_, bit));
}

bool SideThinning::alone(size_t bit) const {
  uint32_t covered = neighborhood(*box_, before_.data(), bit);
  for (; covered != 0; covered &= covered - 1) {
    const int place = __builtin_ctz(covered);
    const ptrdiff_t step = (place / 9 - 1) * ptrdiff_t(box_->plane * 64) +
                           (place / 3 % 3 - 1) * ptrdiff_t(box_->row * 64) + place % 3 - 1;
    const uint32_t by = neighborhood(*box_, object_->data(), size_t(ptrdiff_t(bit) + step));
    if ((by & ~(1u << (26 - place))) == 0) return true;
  }
  return false;
}

bool SideThinning::thinOnce(bool cover) {
  const auto y = ptrdiff_t(box_->row * 64), z = ptrdiff_t(box_->plane * 64);
  soft_.clear();
  for (size_t bit : voxels_)
    if (testBit(*object_, bit) && removable(bit)) soft_.push_back(bit);
  bool removed = false;
  for (ptrdiff_t step : {ptrdiff_t(-1), ptrdiff_t(1), -y, y, -z, z}) {
    side_.clear();
    for (size_t bit : soft_) {
      if (testBit(*object_, bit) && !testBit(*object_, size_t(ptrdiff_t(bit) + step)) &&
          removable(bit))
        side_.push_back(bit);
    }
    for (size_t bit : side_) {
      if (!removable(bit) || (cover && alone(bit))) continue;
      clearBit(object_, bit);
      removed = true;
    }
  }
  return removed;
}

void SideThinning::thin(const BitBox& box, const BitWords& kept, BitWords* object) {
  box_ = &box;
  kept_ = &kept;
  object_ = object;
  before_ = *object;
  voxels_.clear();
  forEachBit(box, *object, [&](size_t bit) { voxels_.push_back(bit); });
  while (thinOnce(true)) continue;
  while (thinOnce(false)) continue;
}

}  // namespace markerless_mocap
