#include "silhouette/boundary/matting_kernels.h"

#include "numerics/simd_clones.h"

#ifdef MOCAP_X86

#include <cstring>

#include "silhouette/bits/avx2_pixels.h"

namespace markerless_mocap {
namespace {

/// The 16 pixels of a block, one byte per pixel and channel, row after row.
struct Planes {
  __m128i channel[3];
};

uint32_t fourAt(const uint8_t* bytes) {
  uint32_t four;
  std::memcpy(&four, bytes, 4);
  return four;
}

MOCAP_AVX2 inline __m128i rowsAt(const uint8_t* bytes, ptrdiff_t step) {
  return _mm_setr_epi32(int(fourAt(bytes)), int(fourAt(bytes + step)),
                        int(fourAt(bytes + 2 * step)), int(fourAt(bytes + 3 * step)));
}

/// One byte, 0 | 255, for each bit.
MOCAP_AVX2 inline __m128i maskOf(BlockBits bits) {
  const __m128i half = _mm_setr_epi8(0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1);
  const __m128i bit = _mm_set1_epi64x(int64_t(0x8040201008040201u));
  const __m128i bytes = _mm_shuffle_epi8(_mm_cvtsi32_si128(bits), half);
  return _mm_cmpeq_epi8(_mm_and_si128(bytes, bit), bit);
}

/// Four pixels of a row, one channel after the other.
MOCAP_AVX2 inline __m128i splitRow(const uint8_t* bgr) {
  const __m128i order = _mm_setr_epi8(0, 3, 6, 9, 1, 4, 7, 10, 2, 5, 8, 11, -1, -1, -1, -1);
  const __m128i first = _mm_loadl_epi64(reinterpret_cast<const __m128i*>(bgr));
  return _mm_shuffle_epi8(_mm_insert_epi32(first, int(fourAt(bgr + 8)), 2), order);
}

MOCAP_AVX2 inline Planes split(const ColorBlock& block) {
  const __m128i row0 = splitRow(block.now), row1 = splitRow(block.now + block.now_step);
  const __m128i row2 = splitRow(block.now + 2 * block.now_step);
  const __m128i row3 = splitRow(block.now + 3 * block.now_step);
  const __m128i upper = _mm_unpacklo_epi32(row0, row1), lower = _mm_unpacklo_epi32(row2, row3);
  return {{_mm_unpacklo_epi64(upper, lower), _mm_unpackhi_epi64(upper, lower),
           _mm_unpacklo_epi64(_mm_unpackhi_epi32(row0, row1), _mm_unpackhi_epi32(row2, row3))}};
}

/// Eight bytes of the low or of the high half.
MOCAP_AVX2 inline __m256 floatsOf(__m128i bytes, bool high) {
  return _mm256_cvtepi32_ps(_mm256_cvtepu8_epi32(high ? _mm_srli_si128(bytes, 8) : bytes));
}

/// Converts two registers of eight 32 bit values; saturates.
MOCAP_AVX2 inline __m128i bytesOf(__m256i low, __m256i high) {
  const __m256i words = _mm256_permute4x64_epi64(_mm256_packs_epi32(low, high), 0xd8);
  return _mm_packus_epi16(_mm256_castsi256_si128(words), _mm256_extracti128_si256(words, 1));
}

struct Alphas {
  __m256i alpha, is_known;  ///< 0..255, 0 | 255
};

MOCAP_AVX2 inline Alphas alphaOf(const Planes& now, const Planes& expected,
                                 const MattingColors& colors, bool high) {
  const __m256 light = _mm256_set1_ps(colors.light);
  __m256 apart = _mm256_setzero_ps(), contrast = _mm256_setzero_ps();
  for (int c = 0; c < 3; ++c) {
    const __m256 lit = _mm256_mul_ps(floatsOf(expected.channel[c], high), light);
    const __m256 off = _mm256_sub_ps(floatsOf(now.channel[c], high), lit);
    const __m256 whole = _mm256_sub_ps(_mm256_set1_ps(colors.person[c]), lit);
    apart = _mm256_add_ps(apart, _mm256_mul_ps(off, off));
    contrast = _mm256_add_ps(contrast, _mm256_mul_ps(whole, whole));
  }
  const __m256 square =
      _mm256_div_ps(_mm256_sub_ps(apart, _mm256_set1_ps(colors.squared_noise)), contrast);
  const __m256 within =
      _mm256_min_ps(_mm256_max_ps(square, _mm256_setzero_ps()), _mm256_set1_ps(1));
  const __m256 alpha = _mm256_mul_ps(_mm256_sqrt_ps(within), _mm256_set1_ps(255));
  const __m256 is_known = _mm256_cmp_ps(contrast, _mm256_set1_ps(colors.min_contrast), _CMP_GE_OQ);
  return {_mm256_cvttps_epi32(alpha), _mm256_srli_epi32(_mm256_castps_si256(is_known), 24)};
}

MOCAP_AVX2 inline uint16_t sumOf(__m128i bytes) {
  const __m128i halves = _mm_sad_epu8(bytes, _mm_setzero_si128());
  return uint16_t(_mm_extract_epi16(halves, 0) + _mm_extract_epi16(halves, 4));
}

}  // namespace

bool hasMattingKernels() {
  return kHasAvx2;
}

MOCAP_AVX2 void addColors(const ColorBlock& block, BlockBits chosen, uint16_t* sums) {
  const Planes now = split(block);
  for (int c = 0; c < 3; ++c)
    sums[c] = uint16_t(sums[c] + sumOf(_mm_and_si128(now.channel[c], maskOf(chosen))));
}

MOCAP_AVX2 void estimateAlpha(const ColorBlock& block, const MattingColors& colors,
                              BlockBits selected, ptrdiff_t alpha_step, uint8_t* alpha) {
  const Planes now = split(block);
  Planes expected;
  for (int c = 0; c < 3; ++c) expected.channel[c] = rowsAt(block.expected[c], block.expected_step);
  const Alphas low = alphaOf(now, expected, colors, false),
               high = alphaOf(now, expected, colors, true);
  const __m128i is_known = _mm_and_si128(maskOf(selected), bytesOf(low.is_known, high.is_known));
  const __m128i preset = rowsAt(alpha, alpha_step);
  const __m128i result = _mm_blendv_epi8(preset, bytesOf(low.alpha, high.alpha), is_known);
  uint8_t out[kMattingBlock * kMattingBlock];
  _mm_storeu_si128(reinterpret_cast<__m128i*>(out), result);
  for (int y = 0; y < kMattingBlock; ++y)
    std::memcpy(alpha + y * alpha_step, out + kMattingBlock * y, kMattingBlock);
}

}  // namespace markerless_mocap

#else

namespace markerless_mocap {

bool hasMattingKernels() {
  return false;
}

void addColors(const ColorBlock&, BlockBits, uint16_t*) {}

void estimateAlpha(const ColorBlock&, const MattingColors&, BlockBits, ptrdiff_t, uint8_t*) {}

}  // namespace markerless_mocap

#endif
