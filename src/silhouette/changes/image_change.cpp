#include "silhouette/changes/image_change.h"

#include "silhouette/bits/bit_morphology.h"

namespace markerless_mocap {

BitMask takeOut(const BitMask& place, int blur, BitMask* mask) {
  mask->remove(place);
  BitMask blurred = dilated(place, blur);
  blurred.remove(*mask);
  return blurred;
}

}  // namespace markerless_mocap
