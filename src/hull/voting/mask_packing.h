#pragma once

#include <cstddef>
#include <cstdint>

namespace markerless_mocap {

/// Packs one row of 8 x 8 pixel tiles: bit 8 * row + column of out[i * stride] is set if that pixel
/// of tile i is not 0.
/// \param rows image rows in this row of tiles, 1 to 8; bits of pixels outside the image are clear
void packTileRow(const uint8_t* pixels, size_t step, int width, int rows, uint64_t* out,
                 size_t stride);
/// packTileRow() without vector instructions.
void packTileRowPlainly(const uint8_t* pixels, size_t step, int width, int rows, uint64_t* out,
                        size_t stride);

/// Computes the next column of a summed-area table over tiles: after[0] is 0, after[y + 1] is
/// before[y + 1] plus the sum over the tiles 0 to y. A tile adds 1 if any pixel is set, and 1 << 32
/// more if all of its pixels in the image are set.
/// \param beside pixels of each tile that lie outside the image
/// \param below the same for the last tile
/// \return number of set pixels
size_t sumTileColumn(const uint64_t* tiles, int rows, uint64_t beside, uint64_t below,
                     const uint64_t* before, uint64_t* after);

}  // namespace markerless_mocap
