#include "silhouette/changed_bits.h"

#if defined(__x86_64__) && defined(__GNUC__)

#include <immintrin.h>

#include <cstring>

#include "silhouette/row_kernels.h"

#define MOCAP_AVX2 __attribute__((target("avx2")))

namespace markerless_mocap {
namespace {

constexpr int kStep = 16, kWord = 64, kMeanBits = 7;
static_assert(Background::kMeanScale == 1 << kMeanBits);

/// 16 pixels, a channel each, 16 bits per value.
struct Pixels {
  __m256i channel[3];
};

MOCAP_AVX2 inline __m128i bytes(const uint8_t* from) {
  return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
}

/// Byte i of `zero`, `one` or `two`, as i modulo 3 says.
MOCAP_AVX2 inline __m128i mixed(__m128i zero, __m128i one, __m128i two) {
  const __m128i is_one = _mm_setr_epi8(0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0);
  const __m128i is_two = _mm_setr_epi8(0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0);
  return _mm_blendv_epi8(_mm_blendv_epi8(zero, one, is_one), two, is_two);
}

/// Of each block of 16 bytes every third belongs to a channel; the three blocks' never meet.
MOCAP_AVX2 inline Pixels split(const uint8_t* bgr) {
  const __m128i a = bytes(bgr), b = bytes(bgr + 16), c = bytes(bgr + 32);
  const __m128i order0 = _mm_setr_epi8(0, 3, 6, 9, 12, 15, 2, 5, 8, 11, 14, 1, 4, 7, 10, 13);
  const __m128i order1 = _mm_setr_epi8(1, 4, 7, 10, 13, 0, 3, 6, 9, 12, 15, 2, 5, 8, 11, 14);
  const __m128i order2 = _mm_setr_epi8(2, 5, 8, 11, 14, 1, 4, 7, 10, 13, 0, 3, 6, 9, 12, 15);
  return {{_mm256_cvtepu8_epi16(_mm_shuffle_epi8(mixed(a, c, b), order0)),
           _mm256_cvtepu8_epi16(_mm_shuffle_epi8(mixed(b, a, c), order1)),
           _mm256_cvtepu8_epi16(_mm_shuffle_epi8(mixed(c, b, a), order2))}};
}

MOCAP_AVX2 inline __m256i widened(const uint8_t* from) {
  return _mm256_cvtepu8_epi16(bytes(from));
}

/// As squaredDistances().
MOCAP_AVX2 inline __m256i squared(const Pixels& now, const ModeRow& mode, int x, __m256i gain) {
  const __m256i weight =
      _mm256_mullo_epi16(widened(mode.weight + x), _mm256_set1_epi16(mode.weight_unit));
  const __m256i farthest = _mm256_set1_epi16(kFarthest);
  __m256i sum = _mm256_setzero_si256();
  for (int c = 0; c < 3; ++c) {
    const __m256i usual =
        _mm256_mulhrs_epi16(_mm256_slli_epi16(widened(mode.mean[c] + x), kMeanBits), gain);
    const __m256i off = _mm256_sub_epi16(_mm256_slli_epi16(now.channel[c], kPredictedBits), usual);
    const __m256i scaled = _mm256_mulhrs_epi16(_mm256_abs_epi16(off), weight);
    const __m256i near = _mm256_min_epi16(scaled, farthest);
    sum = _mm256_add_epi16(sum, _mm256_mullo_epi16(near, near));
  }
  return sum;
}

/// 16 words of 0 or ~0.
MOCAP_AVX2 inline __m256i isNear(const uint8_t* bgr, const ModeRow* modes, int mode_count, int x,
                                 __m256i gain, __m256i limit) {
  const Pixels now = split(bgr);
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
    // Packing works within halves: the middle quarters change places.
    const __m256i flags = _mm256_permute4x64_epi64(_mm256_packs_epi16(low, high), 0xd8);
    word |= uint64_t(~uint32_t(_mm256_movemask_epi8(flags))) << i;
  }
  return word;
}

/// Asks memory for the same word of another row, as it takes longer than this row's arithmetic.
__attribute__((always_inline)) MOCAP_AVX2 inline void fetch(const uint8_t* bgr,
                                                            const ModeRow* modes, int mode_count,
                                                            int x, const RowsAhead& ahead) {
  for (int i = 0; i < 3; ++i) __builtin_prefetch(bgr + ahead.image + kWord * i);
  for (int mode = 0; mode < mode_count; ++mode) {
    for (int c = 0; c < 3; ++c) __builtin_prefetch(modes[mode].mean[c] + x + ahead.background);
    __builtin_prefetch(modes[mode].weight + x + ahead.background);
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
    fetch(bgr + 3 * x, modes, mode_count, x, ahead);
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
  static const bool kHasAvx2 = __builtin_cpu_supports("avx2");
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
