#include "skeleton/simple_point.h"
#include "skeleton/thinning_scheme.h"

namespace markerless_mocap {
namespace {

bool removable(const BitBox& box, const BitWords& object, size_t bit) {
  const uint32_t around = neighborhood(box, object.data(), bit) & ~kCenterBit;
  return (around & (around - 1)) != 0 && SimplePointTable::shared()(around);
}

}  // namespace

void SideThinning::thin(const BitBox& box, BitWords* object) {
  const auto y = ptrdiff_t(box.row * 64), z = ptrdiff_t(box.plane * 64);
  voxels_.clear();
  forEachBit(box, *object, [&](size_t bit) { voxels_.push_back(bit); });
  for (;;) {
    soft_.clear();
    for (size_t bit : voxels_)
      if (testBit(*object, bit) && removable(box, *object, bit)) soft_.push_back(bit);
    if (soft_.empty()) return;
    for (ptrdiff_t step : {ptrdiff_t(-1), ptrdiff_t(1), -y, y, -z, z}) {
      side_.clear();
      for (size_t bit : soft_) {
        if (testBit(*object, bit) && !testBit(*object, size_t(ptrdiff_t(bit) + step)) &&
            removable(box, *object, bit))
          side_.push_back(bit);
      }
      for (size_t bit : side_)
        if (removable(box, *object, bit)) clearBit(object, bit);
    }
  }
}

}  // namespace markerless_mocap
