#pragma once

#include <cstddef>
#include <cstdint>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// Bytes from a row to the row that is processed next.
struct RowsAhead {
  ptrdiff_t image, background;
};

/// One bit for each pixel of the row, set if its squared scaled distance from `gain` x the mean,
/// summed over channels, is above `limit` for each mode. All colour pixels pass this loop; it keeps
/// its values in registers.
/// \param bgr 3 * cols bytes
/// \param wanted if a word is 0, that word of `bits` becomes 0
/// \param bits (cols + 63) / 64 words
/// \return false, with nothing done, if the processor has no AVX2
bool changedBits(const uint8_t* bgr, int cols, const ModeRow* modes, int mode_count, int16_t gain,
                 uint16_t limit, const RowsAhead& ahead, const uint64_t* wanted, uint64_t* bits);

}  // namespace markerless_mocap
