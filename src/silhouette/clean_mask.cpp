#include "silhouette/clean_mask.h"

#include "markerless_mocap/silhouette/silhouette_extractor.h"
#include "silhouette/bit_morphology.h"
#include "silhouette/mask_runs.h"

namespace markerless_mocap {

void fillAndSieve(const SilhouetteOptions& options, BitMask* mask) {
  fillHoles(options.max_hole_px, mask);
  removeBlobs(options.min_blob_px, mask);
}

BitMask cleanBits(const BitMask& mask, const SilhouetteOptions& options) {
  const int open = options.open_radius_px, close = options.close_radius_px;
  BitMask clean = dilated(eroded(mask, open), open);
  clean = eroded(dilated(clean, close), close);
  fillAndSieve(options, &clean);
  return clean;
}

cv::Mat cleanMask(const cv::Mat& mask, const SilhouetteOptions& options) {
  return cleanBits(BitMask::fromMat(mask), options).toMat();
}

}  // namespace markerless_mocap
