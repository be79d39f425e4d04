#pragma once

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

BitMask openedAndClosed(const BitMask& mask, const SilhouetteOptions& options);

/// cleanMask() on bits.
BitMask cleanBits(const BitMask& mask, const SilhouetteOptions& options);

}  // namespace markerless_mocap
