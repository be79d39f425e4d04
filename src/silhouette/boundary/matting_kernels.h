#pragma once

#include <cstddef>
#include <cstdint>

namespace markerless_mocap {

/// Side of the blocks in which the boundary is processed, px.
constexpr int kMattingBlock = 4;

/// A whole block of three channels; steps are bytes from row to row.
struct ColorBlock {
  const uint8_t* now;  ///< in the image, BGR
  ptrdiff_t now_step;
  const uint8_t* expected[3];  ///< in the background
  ptrdiff_t expected_step;
};

/// The two colours of which the pixels of a block are mixtures.
struct MattingColors {
  float person[3];      ///< grey levels
  float light;          ///< of the image, relative to the background's
  float squared_noise;  ///< of a pixel, all channels together, grey levels
  float min_contrast;   ///< squared, all channels together; alpha is not estimated below it
};

/// One bit per pixel of a block, row after row, the first in the lowest bit.
using BlockBits = uint16_t;

/// Whether the processor has what the following functions need. They do the same as BoundaryMatting
/// does pixel by pixel, but faster.
bool hasMattingKernels();

/// Adds the colours of the chosen pixels.
void addColors(const ColorBlock& block, BlockBits chosen, uint16_t* sums);

/// Estimates alpha, 255 for 1, of the selected pixels with enough contrast; other pixels are not
/// changed.
void estimateAlpha(const ColorBlock& block, const MattingColors& colors, BlockBits selected,
                   ptrdiff_t alpha_step, uint8_t* alpha);

}  // namespace markerless_mocap
