#pragma once

#include <cstddef>
#include <cstdint>

namespace markerless_mocap {

/// Side of the blocks in which the rim's colours are looked at, px.
constexpr int kMattingBlock = 4;

/// A whole block of three channels; steps are from row to row, bytes.
struct ColorBlock {
  const uint8_t* now;  ///< in the image, BGR
  ptrdiff_t now_step;
  const uint8_t* expected[3];  ///< in the background
  ptrdiff_t expected_step;
};

/// What its pixels may be made of.
struct MattingColors {
  float person[3];      ///< grey levels
  float light;          ///< of the image, relative to the background's
  float squared_noise;  ///< of a pixel, all channels together, grey levels
  float min_contrast;   ///< squared, all channels together, under which nothing is told
};

/// Sixteen pixels of a block, row after row, the first in the lowest bit.
using BlockBits = uint16_t;

/// Whether the processor can do the following; they are the quick form of what BoundaryMatting does
/// pixel by pixel.
bool hasMattingKernels();

/// Adds the chosen pixels' colours.
void addColors(const ColorBlock& block, BlockBits chosen, uint16_t* sums);

/// The share of the person, 255 = all, of those pixels that are asked for and can be told.
void estimateAlpha(const ColorBlock& block, const MattingColors& colors, BlockBits asked,
                   ptrdiff_t alpha_step, uint8_t* alpha);

}  // namespace markerless_mocap
