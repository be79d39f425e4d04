#include "silhouette/boundary/clean_mask.h"

#include "silhouette/bits/bit_morphology.h"
#include "silhouette/bits/mask_runs.h"

namespace markerless_mocap {

BitMask openedAndClosed(const BitMask& mask, const SilhouetteOptions& options) {
  const int open = options.open_radius_px, close = options.close_radius_px;
  return eroded(dilated(dilated(eroded(mask, open), open), close), close);
}

BitMask cleanBits(const BitMask& mask, const SilhouetteOptions& options) {
  BitMask clean = openedAndClosed(mask, options);
  fillHoles(options.max_hole_px, &clean);
  removeBlobs(options.min_blob_px, &clean);
  return clean;
}

}  // namespace markerless_mocap
