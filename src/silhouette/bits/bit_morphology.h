#pragma once

#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Morphology with a disk, equal to OpenCV's MORPH_ELLIPSE of width 2 * radius + 1. Pixels outside
/// the image neither erode nor dilate. Radius 0 changes nothing.
BitMask dilated(const BitMask& mask, int radius);
BitMask eroded(const BitMask& mask, int radius);

/// Row y of the mask dilated by a rectangle of half sizes `dx`, `dy`. Written to words 1 to
/// rowWords() of `row`; bits right of the image are undefined.
void nearRow(const BitMask& mask, int y, int dx, int dy, std::vector<uint64_t>* row);

}  // namespace markerless_mocap
