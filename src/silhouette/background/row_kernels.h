#pragma once

#include <cstdint>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// The loops over all pixels of all images. They are compiled twice, for any processor and for
/// AVX2; the loader selects the version that fits.

/// Light of an image relative to its background, fixed point: 16384 is a gain of 1.
constexpr int kGainOne = 16384;
/// Fraction bits of a mean times a gain.
constexpr int kPredictedBits = 6;
/// Maximum distance, so that the sum of three squares fits into 16 bits.
constexpr int kMaxDistance = 147;

/// Splits a row of n BGR pixels into three planes that are `stride` bytes apart.
void deinterleaveBgr(const uint8_t* row, int n, int stride, uint8_t* planes);

/// Squared scaled distance of n pixels of one row from `gain` x the mean, summed over channels.
/// \param now one pointer per channel
/// \param squared output, n values
void squaredDistances(const uint8_t* const* now, const ModeRow& mode, int channels, int16_t gain,
                      int n, uint16_t* squared);

void keepSmaller(const uint16_t* other, int n, uint16_t* value);

/// One bit per value, set if the value is above `limit`.
/// \param n a multiple of 64
/// \param flags scratch memory, n bytes
void packAbove(const uint16_t* value, uint16_t limit, int n, uint8_t* flags, uint64_t* bits);

/// Converts n means to grey levels.
void roundMeans(const uint16_t* mean, int n, uint8_t* grey);

/// Erosion and dilation of a word of a mask with the four neighbours of each pixel.
inline uint64_t erodedWord(uint64_t left, uint64_t word, uint64_t right, uint64_t above,
                           uint64_t below) {
  return word & (word << 1 | left >> 63) & (word >> 1 | right << 63) & above & below;
}
inline uint64_t dilatedWord(uint64_t left, uint64_t word, uint64_t right, uint64_t above,
                            uint64_t below) {
  return word | (word << 1 | left >> 63) | (word >> 1 | right << 63) | above | below;
}
/// The same for n words of a row.
/// \param row there is one more word before and one after the n words
void erodeWords(const uint64_t* above, const uint64_t* row, const uint64_t* below, int n,
                uint64_t* out);
void dilateWords(const uint64_t* above, const uint64_t* row, const uint64_t* below, int n,
                 uint64_t* out);

/// Moves n means towards the image by the fraction `rate` / 32768, or, where `held` is not 0,
/// towards `gain` x themselves.
void moveMeans(const uint8_t* now, const uint8_t* held, int16_t gain, int16_t rate, int n,
               uint16_t* mean);

}  // namespace markerless_mocap
