#pragma once

#include "studies/reproduce/hsiao/hsiao_film.h"

namespace markerless_mocap {

/// A capture run through the published system. {"D" of each frame, mm, null where lost, "seconds",
/// "six": whether the segmentation has six parts, of each frame, "lost": share of the frames,
/// "reset": share of the frames whose pose started anew, "swaps": share of frames with left and
/// right exchanged, "jitter": mean second difference of the joints, mm, "strip": JPEG of a film
/// strip in base64, if `strip`}
Json trackSequence(const Capture& capture, const Overrides& changes, bool strip);

/// How well the hulls of a capture are cut into parts by variants of the segmentation, over the
/// same frames. {variant: {"correct": share of the voxels, "six": share of frames with six parts
/// found (each overlaps the true one by half), "overlap": by part, "found": by part, share of the
/// frames with an overlap over a half, "curve_mm": torso, head, arms, legs}}
struct PartVariant {
  std::string name;
  std::string title;  ///< in tables
  Overrides changes;  ///< of body_segmentation
};
const std::vector<PartVariant>& partVariants();
Json segmentSequence(const Capture& capture);

}  // namespace markerless_mocap
