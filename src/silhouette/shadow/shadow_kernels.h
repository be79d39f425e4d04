#pragma once

#include <cstdint>

#include "silhouette/background/row_kernels.h"

namespace markerless_mocap {

/// As shadowRatios() of three channels, from the image's bytes without leaving the registers.
/// \param bgr 3 x 64 bytes \param x of the first of them in `mode`
/// \param asked a bit for each pixel \param ratio 64 bytes, defined where `shade`
/// \param shade the pixels that are one
/// \return whether the processor can; else nothing is done
bool shadowRatiosOfBgr(const uint8_t* bgr, const ModeRow& mode, int x, float gain,
                       const PixelShadowThresholds& limits, uint64_t asked, uint8_t* ratio,
                       uint64_t* shadow, ShadowColumns* columns);

}  // namespace markerless_mocap
