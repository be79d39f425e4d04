#pragma once

#include "silhouette/bit_mask.h"

namespace markerless_mocap {

/// Sets the 4-connected holes of at most `max_area` pixels that do not touch the image's border.
void fillHoles(int max_area, BitMask* mask);

/// Clears the 8-connected components of fewer than `min_area` pixels.
void removeBlobs(int min_area, BitMask* mask);

}  // namespace markerless_mocap
