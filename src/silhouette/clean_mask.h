#pragma once

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/bit_mask.h"

namespace markerless_mocap {

BitMask openedAndClosed(const BitMask& mask, const SilhouetteOptions& options);

/// cleanMask() on bits.
BitMask cleanBits(const BitMask& mask, const SilhouetteOptions& options);

/// Fills holes up to `max_hole_px` and removes blobs under `min_blob_px`.
void fillAndSieve(const SilhouetteOptions& options, BitMask* mask);

}  // namespace markerless_mocap
