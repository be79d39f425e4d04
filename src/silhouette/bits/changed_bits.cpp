#include "silhouette/bits/changed_bits.h"

#include "numerics/simd_clones.h"

#ifdef MOCAP_X86

#include <cstring>

#include "silhouette/background/row_kernels.h"
#include "silhouette/bits/avx2_pixels.h"
#include "silhouette/bits/prefetch.h"

namespace markerless_mocap {
namespace {

constexpr int kStep = 16, kWord = 64, kMeanBits = 7;
static_assert(Background::kMeanScale == 1 << kMeanBits);

/// The same as squaredDistances().
MOCAP_AVX2 inline __m256i squared(const WidePixels& now, const ModeRow& mode, int x, __m256i gain) {
  const __m256i weight =
      _mm256_mullo_epi16(widened(mode.weight + x), _mm256_set1_epi16(mode.weight_unit));
  const __m256i farthest = _mm256_set1_epi16(kMaxDistance);
  __m256i sum = _mm256_setzero_si256();
  for (int c = 0; c < 3; ++c) {
    const __m256i expected =
        _mm256_mulhrs_epi16(_mm256_slli_epi16(widened(mode.mean[c] + x), kMeanBits), gain);
    const __m256i off =
        _mm256_sub_epi16(_mm256_slli_epi16(now.channel[c], kPredictedBits), expected);
    const __m256i scaled = _mm256_mulhrs_epi16(_mm256_abs_epi16(off), weight);
    const __m256i near = _mm256_min_epi16(scaled, farthest);
    sum = _mm256_add_epi16(sum, _mm256_mullo_epi16(near, near));
  }
  return sum;
}

/// 16 values of 0 or ~0.
MOCAP_AVX2 inline __m256i isNear(const uint8_t* bgr, const ModeRow* modes, int mode_count, int x,
                                 __m256i gain, __m256i limit) {
  const WidePixels now = splitPixels(bgr);
  __m256i least = squared(now, modes[0], x, gain);
  for (int mode = 1; mode < mode_count; ++mode)
    least = _mm256_min_epu16(least, squared(now, modes[mode], x, gain));
  return _mm256_cmpeq_epi16(_mm256_subs_epu16(least, limit), _mm256_setzero_si256());
}

MOCAP_AVX2 uint64_t changedWord(const uint8_t* bgr, const ModeRow* modes, int mode_count, int x,
                                __m256i gain, __m256i limit) {
  uint64_t word = 0;
  for (int i = 0; i < kWord; i += 2 * kStep) {
    const __m256i low = isNear(bgr + 3 * i, modes, mode_count, x + i, gain, limit);
    const __m256i high =
        isNear(bgr + 3 * (i + kStep), modes, mode_count, x + i + kStep, gain, limit);
    // Packing works within halves, so the two middle quarters are exchanged.
    const __m256i flags = _mm256_permute4x64_epi64(_mm256_packs_epi16(low, high), 0xd8);
    word |= uint64_t(~uint32_t(_mm256_movemask_epi8(flags))) << i;
  }
  return word;
}

/// Prefetches the same word of another row.
MOCAP_AVX2_INLINE void prefetchWord(const uint8_t* bgr, const ModeRow* modes, int mode_count, int x,
                                    const RowsAhead& ahead) {
  prefetch(bgr + ahead.image, 3 * kWord);
  for (int mode = 0; mode < mode_count; ++mode) {
    for (int c = 0; c < 3; ++c) prefetch(modes[mode].mean[c] + x + ahead.background, kWord);
    prefetch(modes[mode].weight + x + ahead.background, kWord);
  }
}

MOCAP_AVX2 void changedBitsAvx2(const uint8_t* bgr, int cols, const ModeRow* modes, int mode_count,
                                int16_t gain, uint16_t limit, const RowsAhead& ahead,
                                const uint64_t* wanted, uint64_t* bits) {
  const __m256i gains = _mm256_set1_epi16(gain), limits = _mm256_set1_epi16(int16_t(limit));
  int x = 0;
  for (; x + kWord <= cols; x += kWord, ++wanted, ++bits) {
    *bits = 0;
    if (!*wanted) continue;
    prefetchWord(bgr + 3 * x, modes, mode_count, x, ahead);
    *bits = changedWord(bgr + 3 * x, modes, mode_count, x, gains, limits);
  }
  if (x == cols) return;
  *bits = 0;
  if (!*wanted) return;
  uint8_t rest[3 * kWord] = {};
  std::memcpy(rest, bgr + 3 * x, size_t(3) * (cols - x));
  *bits = changedWord(rest, modes, mode_count, x, gains, limits);
}

}  // namespace

bool changedBits(const uint8_t* bgr, int cols, const ModeRow* modes, int mode_count, int16_t gain,
                 uint16_t limit, const RowsAhead& ahead, const uint64_t* wanted, uint64_t* bits) {
  if (kHasAvx2) changedBitsAvx2(bgr, cols, modes, mode_count, gain, limit, ahead, wanted, bits);
  return kHasAvx2;
}

}  // namespace markerless_mocap

#else

namespace markerless_mocap {

bool changedBits(const uint8_t*, int, const ModeRow*, int, int16_t, uint16_t, const RowsAhead&,
                 const uint64_t*, uint64_t*) {
  return false;
}

}  // namespace markerless_mocap

#endif
