#pragma once

#include <cstdint>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// The loops that every pixel of every image passes through. They are compiled once for any
/// processor and once for AVX2; the loader takes the one that fits.

/// Light of an image relative to its background, fixed point: 16384 is the same light.
constexpr int kGainOne = 16384;
/// Fixed point of a mean times a gain: bits below a grey level.
constexpr int kPredictedBits = 6;
/// Distances saturate here, so that the sum of three squares fits 16 bits.
constexpr int kFarthest = 147;

/// One row of n pixels, BGR one after the other, into three planes that lie `stride` bytes apart.
void splitThree(const uint8_t* row, int n, int stride, uint8_t* planes);

/// Squared scaled distance of n pixels of one row from `gain` x the mean, summed over channels.
/// \param now one pointer per channel \param squared n values out
void squaredDistances(const uint8_t* const* now, const ModeRow& mode, int channels, int16_t gain,
                      int n, uint16_t* squared);

void keepSmaller(const uint16_t* other, int n, uint16_t* value);

/// One bit per value, set if it is above `limit`. \param n a multiple of 64 \param flags scratch, n
void packAbove(const uint16_t* value, uint16_t limit, int n, uint8_t* flags, uint64_t* bits);

struct PixelShadowThresholds {
  float darkest;         ///< least brightness relative to the background's
  float squared_chroma;  ///< tolerance of the colour's change, relative, squared
  float squared_noise;   ///< grey levels, squared
};

/// Shades of 64 pixels in each of up to kMostRows rows, summed column by column.
struct ShadowColumns {
  static constexpr int kMostRows = 4, kCols = 64;
  uint16_t count[kCols] = {};
  uint16_t now[3][kCols] = {};       ///< their colour in the image
  uint16_t expected[3][kCols] = {};  ///< and in the background
  uint16_t ratio[kCols] = {};        ///< their brightness relative to the background's, 127 for 1
  uint16_t squares[kCols] = {};      ///< of the ratios
};

/// Brightness of 64 pixels of one row relative to `gain` x the mean where they are a darker shade
/// of it, 255 for 1; 0 where they are not. \param now one pointer per channel, to pixel x
/// \param asked 255 for the pixels that are asked for, else 0 \param columns the shades are added
void shadowRatios(const uint8_t* const* now, const ModeRow& mode, int x, int channels, float gain,
                  const PixelShadowThresholds& limits, const uint8_t* asked, uint8_t* ratio,
                  ShadowColumns* columns);

/// n means in grey levels.
void roundMeans(const uint16_t* mean, int n, uint8_t* grey);

/// A word of a mask with its pixels' four neighbours: all set, or any.
inline uint64_t erodedWord(uint64_t left, uint64_t word, uint64_t right, uint64_t above,
                           uint64_t below) {
  return word & (word << 1 | left >> 63) & (word >> 1 | right << 63) & above & below;
}
inline uint64_t dilatedWord(uint64_t left, uint64_t word, uint64_t right, uint64_t above,
                            uint64_t below) {
  return word | (word << 1 | left >> 63) | (word >> 1 | right << 63) | above | below;
}
/// Of n words in a row. \param row one more before and behind them
void erodeWords(const uint64_t* above, const uint64_t* row, const uint64_t* below, int n,
                uint64_t* out);
void dilateWords(const uint64_t* above, const uint64_t* row, const uint64_t* below, int n,
                 uint64_t* out);

/// Moves n means by `rate` / 32768 of the way to the image, or where `held` is not 0 to `gain` x
/// themselves.
void moveMeans(const uint8_t* now, const uint8_t* held, int16_t gain, int16_t rate, int n,
               uint16_t* mean);

}  // namespace markerless_mocap
