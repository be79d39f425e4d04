#include "silhouette/changes/image_change.h"

#include "silhouette/bits/bit_morphology.h"

namespace markerless_mocap {

BitMask takeOut(BitMask place, int blur, BitMask* mask) {
  for (size_t i = 0; i < place.words().size(); ++i) mask->words()[i] &= ~place.words()[i];
  place = dilated(place, blur);
  for (size_t i = 0; i < place.words().size(); ++i) place.words()[i] &= ~mask->words()[i];
  return place;
}

}  // namespace markerless_mocap
