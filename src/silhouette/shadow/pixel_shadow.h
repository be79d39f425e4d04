#pragma once

#include <cstdint>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// The shadow test of single pixels. shadow_kernels.h has its form for three channels and AVX2;
/// both give the same result, so change them together.

struct PixelShadowThresholds {
  float min_brightness;  ///< minimum brightness relative to the background's
  float squared_chroma;  ///< tolerance of the change of colour, relative, squared
  float squared_noise;   ///< grey levels, squared
};

/// Shadow pixels of 64 columns in up to kMaxRows rows, summed column by column.
struct ShadowColumns {
  static constexpr int kMaxRows = 4, kCols = 64;
  uint16_t count[kCols] = {};
  uint16_t now[3][kCols] = {};       ///< their colour in the image
  uint16_t expected[3][kCols] = {};  ///< and in the background
  uint16_t ratio[kCols] = {};        ///< their brightness relative to the background's, 127 for 1
  uint16_t squares[kCols] = {};      ///< of the ratios
};

/// Brightness of 64 pixels of one row relative to `gain` x the mean, 255 for 1, if they are a
/// shadow on it; else 0.
/// \param now one pointer per channel, to pixel x
/// \param selected 255 for the pixels to test, else 0
/// \param columns the shadow pixels are added to it
void shadowRatios(const uint8_t* const* now, const ModeRow& mode, int x, int channels, float gain,
                  const PixelShadowThresholds& limits, const uint8_t* selected, uint8_t* ratio,
                  ShadowColumns* columns);

}  // namespace markerless_mocap
