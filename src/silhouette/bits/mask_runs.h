#pragma once

#include <functional>
#include <vector>

#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// A run of pixels of a row, both ends included.
struct MaskRun {
  int y, first, last;
};

/// Sets the 4-connected holes of at most `max_area` pixels that do not touch the image's border.
void fillHoles(int max_area, BitMask* mask);

/// The same for holes of at most `always` pixels, and for those of at most `max_area` pixels that
/// `is_filled` picks by their runs.
void fillHoles(int always, int max_area,
               const std::function<bool(const std::vector<MaskRun>&)>& is_filled, BitMask* mask);

/// The 4-connected components of at most `max_area` pixels, by their runs.
std::vector<std::vector<MaskRun>> findBlobs(int max_area, const BitMask& mask);

void fillRuns(const std::vector<MaskRun>& runs, BitMask* mask);

/// Clears the 8-connected components of fewer than `min_area` pixels.
void removeBlobs(int min_area, BitMask* mask);

}  // namespace markerless_mocap
