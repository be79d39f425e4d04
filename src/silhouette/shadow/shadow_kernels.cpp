#include "silhouette/shadow/shadow_kernels.h"

#include "numerics/simd_clones.h"

#ifdef MOCAP_X86

#include "silhouette/bits/avx2_pixels.h"

namespace markerless_mocap {
namespace {

constexpr int kStep = 16;

/// Sums over the channels of 16 pixels, in two registers of eight; not in order, as the
/// instructions give them.
struct Sums {
  __m256i low, high;
};

MOCAP_AVX2_INLINE Sums productsOf(const WidePixels& a, const WidePixels& b) {
  const __m256i zero = _mm256_setzero_si256();
  const auto sum = [&](__m256i a0, __m256i b0, __m256i a1, __m256i b1) MOCAP_AVX2
      __attribute__((always_inline)) {
    return _mm256_add_epi32(_mm256_madd_epi16(a0, b0), _mm256_madd_epi16(a1, b1));
  };
  return {
      sum(_mm256_unpacklo_epi16(a.channel[0], a.channel[1]),
          _mm256_unpacklo_epi16(b.channel[0], b.channel[1]),
          _mm256_unpacklo_epi16(a.channel[2], zero), _mm256_unpacklo_epi16(b.channel[2], zero)),
      sum(_mm256_unpackhi_epi16(a.channel[0], a.channel[1]),
          _mm256_unpackhi_epi16(b.channel[0], b.channel[1]),
          _mm256_unpackhi_epi16(a.channel[2], zero), _mm256_unpackhi_epi16(b.channel[2], zero))};
}

/// As in shadowRatios(): the brightness ratio of eight pixels, 255 for 1; 0 if a pixel is no
/// shadow.
MOCAP_AVX2_INLINE __m256i shadowsOf(__m256i crosses, __m256i expected_squares, __m256i nows,
                                    float gain, const PixelShadowThresholds& limits) {
  const __m256 cross = _mm256_mul_ps(_mm256_cvtepi32_ps(crosses), _mm256_set1_ps(gain));
  const __m256 expected =
      _mm256_mul_ps(_mm256_cvtepi32_ps(expected_squares), _mm256_set1_ps(gain * gain));
  const __m256 ratio = _mm256_div_ps(cross, _mm256_add_ps(expected, _mm256_set1_ps(1e-6f)));
  const __m256 off = _mm256_sub_ps(_mm256_cvtepi32_ps(nows), _mm256_mul_ps(ratio, cross));
  const __m256 chroma = _mm256_mul_ps(_mm256_set1_ps(limits.squared_chroma), ratio);
  const __m256 allowed = _mm256_add_ps(_mm256_mul_ps(_mm256_mul_ps(chroma, ratio), expected),
                                       _mm256_set1_ps(limits.squared_noise));
  const __m256 is_dark_enough =
      _mm256_and_ps(_mm256_cmp_ps(ratio, _mm256_set1_ps(limits.min_brightness), _CMP_GE_OQ),
                    _mm256_cmp_ps(ratio, _mm256_set1_ps(1), _CMP_LT_OQ));
  const __m256 is_shade = _mm256_and_ps(is_dark_enough, _mm256_cmp_ps(off, allowed, _CMP_LT_OQ));
  const __m256 scaled = _mm256_mul_ps(ratio, _mm256_set1_ps(255));
  return _mm256_cvttps_epi32(_mm256_and_ps(scaled, is_shade));
}

MOCAP_AVX2_INLINE void add(__m256i values, uint16_t* sums) {
  __m256i* at = reinterpret_cast<__m256i*>(sums);
  _mm256_storeu_si256(at, _mm256_add_epi16(_mm256_loadu_si256(at), values));
}

/// A value of 0 | ~0 for each of the lowest 16 bits.
MOCAP_AVX2_INLINE __m256i wordsOf(unsigned bits) {
  const __m256i bit = _mm256_setr_epi16(1, 2, 4, 8, 16, 32, 64, 128, 256, 512, 1024, 2048, 4096,
                                        8192, 16384, int16_t(-32768));
  return _mm256_cmpeq_epi16(_mm256_and_si256(_mm256_set1_epi16(int16_t(bits)), bit), bit);
}

/// Adds the shadow pixels of sixteen pixels.
/// \return one bit per pixel, set for shadows
MOCAP_AVX2_INLINE unsigned addShadows(const uint8_t* bgr, const ModeRow& mode, int x, int column,
                                      float gain, const PixelShadowThresholds& limits,
                                      unsigned selected, uint8_t* ratio, ShadowColumns* columns) {
  const WidePixels now = splitPixels(bgr);
  const WidePixels expected = {
      {widened(mode.mean[0] + x), widened(mode.mean[1] + x), widened(mode.mean[2] + x)}};
  const Sums crosses = productsOf(now, expected), expected_squares = productsOf(expected, expected),
             nows = productsOf(now, now);
  // Packing restores the order.
  const __m256i all =
      _mm256_packus_epi32(shadowsOf(crosses.low, expected_squares.low, nows.low, gain, limits),
                          shadowsOf(crosses.high, expected_squares.high, nows.high, gain, limits));
  const __m256i shadows = _mm256_and_si256(all, wordsOf(selected));
  const __m256i is_none = _mm256_cmpeq_epi16(shadows, _mm256_setzero_si256());
  const __m128i flags =
      _mm_packs_epi16(_mm256_castsi256_si128(is_none), _mm256_extracti128_si256(is_none, 1));
  const unsigned found = 0xffffu & ~unsigned(_mm_movemask_epi8(flags));
  if (!found) return 0;
  const __m128i bytes =
      _mm_packus_epi16(_mm256_castsi256_si128(shadows), _mm256_extracti128_si256(shadows, 1));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(ratio), bytes);
  const __m256i half = _mm256_srli_epi16(shadows, 1);  // four squares fit 16 bits
  add(_mm256_add_epi16(_mm256_set1_epi16(1), is_none), columns->count + column);
  add(half, columns->ratio + column);
  add(_mm256_mullo_epi16(half, half), columns->squares + column);
  for (int c = 0; c < 3; ++c) {
    add(_mm256_andnot_si256(is_none, now.channel[c]), columns->now[c] + column);
    add(_mm256_andnot_si256(is_none, expected.channel[c]), columns->expected[c] + column);
  }
  return found;
}

MOCAP_AVX2 uint64_t shadowsAvx2(const uint8_t* bgr, const ModeRow& mode, int x, float gain,
                                const PixelShadowThresholds& limits, uint64_t selected,
                                uint8_t* ratio, ShadowColumns* columns) {
  uint64_t shadow = 0;
  for (int i = 0; i < ShadowColumns::kCols; i += kStep)
    if (const unsigned some = selected >> i & 0xffffu)
      shadow |=
          uint64_t(addShadows(bgr + 3 * i, mode, x + i, i, gain, limits, some, ratio + i, columns))
          << i;
  return shadow;
}

}  // namespace

bool shadowRatiosOfBgr(const uint8_t* bgr, const ModeRow& mode, int x, float gain,
                       const PixelShadowThresholds& limits, uint64_t selected, uint8_t* ratio,
                       uint64_t* shadow, ShadowColumns* columns) {
  if (kHasAvx2) *shadow = shadowsAvx2(bgr, mode, x, gain, limits, selected, ratio, columns);
  return kHasAvx2;
}

}  // namespace markerless_mocap

#else

namespace markerless_mocap {

bool shadowRatiosOfBgr(const uint8_t*, const ModeRow&, int, float, const PixelShadowThresholds&,
                       uint64_t, uint8_t*, uint64_t*, ShadowColumns*) {
  return false;
}

}  // namespace markerless_mocap

#endif
