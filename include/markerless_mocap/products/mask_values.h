#pragma once

#include <cstdint>

namespace markerless_mocap {

/// Values of a silhouette mask's pixels. Unknown: the background there has not been seen, so that
/// the pixel may be person.
constexpr uint8_t kBackgroundPixel = 0, kUnknownPixel = 128, kPersonPixel = 255;

}  // namespace markerless_mocap
