#pragma once

#include <cstddef>
#include <cstdint>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// From a row to the one that will be asked for next, bytes.
struct RowsAhead {
  ptrdiff_t image, background;
};

/// One bit for each of the row's pixels, set if its squared scaled distance from `gain` x each of
/// the modes' means, summed over channels, is above `limit`. The loop that every colour pixel
/// passes through: from the image's bytes to bits without leaving the registers.
/// \param bgr 3 x cols bytes \param wanted where this word is 0 that of `bits` becomes 0
/// \param bits (cols + 63) / 64 words
/// \return whether the processor can; else nothing is done
bool changedBits(const uint8_t* bgr, int cols, const ModeRow* modes, int mode_count, int16_t gain,
                 uint16_t limit, const RowsAhead& ahead, const uint64_t* wanted, uint64_t* bits);

}  // namespace markerless_mocap
