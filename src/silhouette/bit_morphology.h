#pragma once

#include "silhouette/bit_mask.h"

namespace markerless_mocap {

/// Morphology with a disk, the same as OpenCV's MORPH_ELLIPSE of width 2 radius + 1. What lies
/// outside the image neither erodes nor dilates. Radius 0 changes nothing.
BitMask dilated(const BitMask& mask, int radius);
BitMask eroded(const BitMask& mask, int radius);

/// With a rectangle of half sizes `dx`, `dy`.
BitMask dilatedByBox(const BitMask& mask, int dx, int dy);

}  // namespace markerless_mocap
