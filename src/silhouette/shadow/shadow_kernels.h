#pragma once

#include <cstdint>

#include "silhouette/shadow/pixel_shadow.h"

namespace markerless_mocap {

/// The same as shadowRatios() for three channels, computed from the image's bytes in registers.
/// \param bgr 3 * 64 bytes
/// \param x column of the first pixel in `mode`
/// \param selected one bit per pixel
/// \param ratio output, 64 bytes, defined for the pixels of `shadow`
/// \param shadow output, one bit per pixel
/// \return false, with nothing done, if the processor has no AVX2
bool shadowRatiosOfBgr(const uint8_t* bgr, const ModeRow& mode, int x, float gain,
                       const PixelShadowThresholds& limits, uint64_t selected, uint8_t* ratio,
                       uint64_t* shadow, ShadowColumns* columns);

}  // namespace markerless_mocap
