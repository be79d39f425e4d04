#pragma once

#include <cstddef>
#include <cstdint>

namespace markerless_mocap {

/// Packs one row of 8 x 8 pixel tiles: bit 8 * row + column of out[i * stride] is whether that
/// pixel of tile i is not 0. \param rows of the image in this row of tiles, 1 to 8; pixels outside
/// the image are clear
void packTileRow(const uint8_t* pixels, size_t step, int width, int rows, uint64_t* out,
                 size_t stride);
/// packTileRow() without vector instructions.
void packTileRowPlainly(const uint8_t* pixels, size_t step, int width, int rows, uint64_t* out,
                        size_t stride);

/// Next column of a summed-area table over tiles: after[0] is 0, after[y + 1] = before[y + 1] + the
/// tiles 0 to y; 1 for a tile with any pixel, 1 << 32 more for one with all of its pixels in the
/// image. \param beside pixels of each tile outside the image \param below those of the last tile
/// \return set pixels
size_t sumTileColumn(const uint64_t* tiles, int rows, uint64_t beside, uint64_t below,
                     const uint64_t* before, uint64_t* after);

}  // namespace markerless_mocap
