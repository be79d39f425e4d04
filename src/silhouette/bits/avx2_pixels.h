#pragma once

/// Only for code that is compiled for AVX2.

#include <cstdint>

#include "numerics/simd_clones.h"

namespace markerless_mocap {

/// 16 pixels, one register per channel, 16 bits per value.
struct WidePixels {
  __m256i channel[3];
};

MOCAP_AVX2_INLINE __m128i bytesAt(const uint8_t* from) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

MOCAP_AVX2_INLINE __m256i widened(const uint8_t* from) {
  return _mm256_cvtepu8_epi16(bytesAt(from));
}

/// Byte i of `zero`, `one` or `two` if i modulo 3 is 0, 1 or 2.
MOCAP_AVX2_INLINE __m128i blendThirds(__m128i zero, __m128i one, __m128i two) {
  const __m128i is_one = _mm_setr_epi8(0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0);
  const __m128i is_two = _mm_setr_epi8(0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0);
  return _mm_blendv_epi8(_mm_blendv_epi8(zero, one, is_one), two, is_two);
}

/// Every third byte of the three blocks of 16 belongs to a channel; their positions in the blocks
/// do not overlap.
MOCAP_AVX2_INLINE WidePixels splitPixels(const uint8_t* bgr) {
  const __m128i a = bytesAt(bgr), b = bytesAt(bgr + 16), c = bytesAt(bgr + 32);
  const __m128i order0 = _mm_setr_epi8(0, 3, 6, 9, 12, 15, 2, 5, 8, 11, 14, 1, 4, 7, 10, 13);
  const __m128i order1 = _mm_setr_epi8(1, 4, 7, 10, 13, 0, 3, 6, 9, 12, 15, 2, 5, 8, 11, 14);
  const __m128i order2 = _mm_setr_epi8(2, 5, 8, 11, 14, 1, 4, 7, 10, 13, 0, 3, 6, 9, 12, 15);
  return {{_mm256_cvtepu8_epi16(_mm_shuffle_epi8(blendThirds(a, c, b), order0)),
           _mm256_cvtepu8_epi16(_mm_shuffle_epi8(blendThirds(b, a, c), order1)),
           _mm256_cvtepu8_epi16(_mm_shuffle_epi8(blendThirds(c, b, a), order2))}};
}

}  // namespace markerless_mocap
