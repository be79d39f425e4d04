#pragma once

#include "markerless_mocap/silhouette/silhouette_options.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

BitMask openedAndClosed(const BitMask& mask, const SilhouetteOptions& options);

/// Opening, closing, filling of holes of up to `max_hole_px` pixels, removal of blobs of less than
/// `min_blob_px` pixels.
BitMask cleanBits(const BitMask& mask, const SilhouetteOptions& options);

}  // namespace markerless_mocap
