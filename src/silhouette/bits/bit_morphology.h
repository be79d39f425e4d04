#pragma once

#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Morphology with a disk, the same as OpenCV's MORPH_ELLIPSE of width 2 radius + 1. What lies
/// outside the image neither erodes nor dilates. Radius 0 changes nothing.
BitMask dilated(const BitMask& mask, int radius);
BitMask eroded(const BitMask& mask, int radius);

/// One row of the mask dilated by a rectangle of half sizes `dx`, `dy`: words 1 to rowWords() of
/// `row`, bits right of the image undefined.
void nearRow(const BitMask& mask, int y, int dx, int dy, std::vector<uint64_t>* row);

}  // namespace markerless_mocap
