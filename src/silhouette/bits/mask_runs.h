#pragma once

#include <functional>
#include <vector>

#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// A run of pixels of a row, both ends inclusive.
struct MaskRun {
  int y, first, last;
};

/// Fills the 4-connected holes of up to `max_area` pixels that do not touch the image border.
void fillHoles(int max_area, BitMask* mask);

/// Fills holes of up to `always` pixels, and holes of up to `max_area` pixels for whose runs
/// `is_filled` returns true.
void fillHoles(int always, int max_area,
               const std::function<bool(const std::vector<MaskRun>&)>& is_filled, BitMask* mask);

/// The runs of each 4-connected component of up to `max_area` pixels.
std::vector<std::vector<MaskRun>> findBlobs(int max_area, const BitMask& mask);

void fillRuns(const std::vector<MaskRun>& runs, BitMask* mask);

/// Clears the 8-connected components of fewer than `min_area` pixels.
void removeBlobs(int min_area, BitMask* mask);

}  // namespace markerless_mocap
