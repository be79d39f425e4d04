#include "silhouette/background/row_kernels.h"

#include <algorithm>
#include <cstddef>

#include "numerics/simd_clones.h"
#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {
namespace {

/// Half of kMeanScale: the scale of a mean after the product with a gain.
constexpr int kPredictedScale = Background::kMeanScale / 2;
static_assert(kPredictedScale == 1 << kPredictedBits);

/// a * b / 32768, rounded: one instruction for 16 pixels with AVX2.
__attribute__((always_inline)) inline int16_t product(int16_t a, int16_t b) {
  return int16_t(((int32_t(a) * b >> 14) + 1) >> 1);
}

__attribute__((always_inline)) inline uint16_t square(uint8_t now, uint8_t mean, int16_t weight,
                                                      int16_t gain) {
  const int16_t expected = product(int16_t(mean * Background::kMeanScale), gain);
  const int16_t off = int16_t(now * kPredictedScale - expected);
  const int16_t apart = int16_t(off < 0 ? -off : off);
  const int16_t far = product(apart, weight);
  const int16_t near = far < kMaxDistance ? far : int16_t(kMaxDistance);
  return uint16_t(near * near);
}

MOCAP_VECTORISED void splitInto(const uint8_t* __restrict row, int n, uint8_t* __restrict plane0,
                                uint8_t* __restrict plane1, uint8_t* __restrict plane2) {
  for (size_t i = 0; i < size_t(n); ++i) {
    plane0[i] = row[3 * i];
    plane1[i] = row[3 * i + 1];
    plane2[i] = row[3 * i + 2];
  }
}

MOCAP_VECTORISED void squaresOfOne(const uint8_t* __restrict now, const uint8_t* __restrict mean,
                                   const uint8_t* __restrict weight, int16_t unit, int16_t gain,
                                   int n, uint16_t* __restrict squared) {
  for (int i = 0; i < n; ++i) squared[i] = square(now[i], mean[i], int16_t(weight[i] * unit), gain);
}

MOCAP_VECTORISED void squaresOfThree(const uint8_t* __restrict now0, const uint8_t* __restrict now1,
                                     const uint8_t* __restrict now2,
                                     const uint8_t* __restrict mean0,
                                     const uint8_t* __restrict mean1,
                                     const uint8_t* __restrict mean2,
                                     const uint8_t* __restrict weight, int16_t unit, int16_t gain,
                                     int n, uint16_t* __restrict squared) {
  for (int i = 0; i < n; ++i) {
    const int16_t weighted = int16_t(weight[i] * unit);
    squared[i] = uint16_t(square(now0[i], mean0[i], weighted, gain) +
                          square(now1[i], mean1[i], weighted, gain) +
                          square(now2[i], mean2[i], weighted, gain));
  }
}

MOCAP_VECTORISED void flagsAbove(const uint16_t* __restrict value, uint16_t limit, int n,
                                 uint8_t* __restrict flags) {
  for (int i = 0; i < n; ++i) flags[i] = value[i] > limit ? 1 : 0;
}

}  // namespace

// Used instead of OpenCV's split, which bypasses the cache, so that the next loop would have to
// wait.
void deinterleaveBgr(const uint8_t* row, int n, int stride, uint8_t* planes) {
  splitInto(row, n, planes, planes + stride, planes + 2 * size_t(stride));
}

void squaredDistances(const uint8_t* const* now, const ModeRow& mode, int channels, int16_t gain,
                      int n, uint16_t* squared) {
  if (channels == 3)
    squaresOfThree(now[0], now[1], now[2], mode.mean[0], mode.mean[1], mode.mean[2], mode.weight,
                   mode.weight_unit, gain, n, squared);
  else
    squaresOfOne(now[0], mode.mean[0], mode.weight, mode.weight_unit, gain, n, squared);
}

MOCAP_VECTORISED void keepSmaller(const uint16_t* __restrict other, int n,
                                  uint16_t* __restrict value) {
  for (int i = 0; i < n; ++i) value[i] = std::min(value[i], other[i]);
}

void packAbove(const uint16_t* value, uint16_t limit, int n, uint8_t* flags, uint64_t* bits) {
  flagsAbove(value, limit, n, flags);
  for (int i = 0; i < n / 64; ++i) bits[i] = packFlags(flags + size_t(64) * i);
}

MOCAP_VECTORISED void roundMeans(const uint16_t* __restrict mean, int n, uint8_t* __restrict grey) {
  constexpr uint16_t kHalf = Background::kMeanScale / 2;
  for (int i = 0; i < n; ++i) grey[i] = uint8_t(uint16_t(mean[i] + kHalf) / Background::kMeanScale);
}

MOCAP_VECTORISED void erodeWords(const uint64_t* __restrict above, const uint64_t* __restrict row,
                                 const uint64_t* __restrict below, int n,
                                 uint64_t* __restrict out) {
  for (int i = 0; i < n; ++i)
    out[i] = erodedWord(row[i - 1], row[i], row[i + 1], above[i], below[i]);
}

MOCAP_VECTORISED void dilateWords(const uint64_t* __restrict above, const uint64_t* __restrict row,
                                  const uint64_t* __restrict below, int n,
                                  uint64_t* __restrict out) {
  for (int i = 0; i < n; ++i)
    out[i] = dilatedWord(row[i - 1], row[i], row[i + 1], above[i], below[i]);
}

MOCAP_VECTORISED void moveMeans(const uint8_t* __restrict now, const uint8_t* __restrict held,
                                int16_t gain, int16_t rate, int n, uint16_t* __restrict mean) {
  constexpr int16_t kBrightest = 255 * kPredictedScale;
  for (int i = 0; i < n; ++i) {
    const int16_t from = int16_t(mean[i]), lit = product(from, gain);
    const int16_t brighter = int16_t(2 * (lit < kBrightest ? lit : kBrightest));
    const int16_t seen = int16_t(now[i] * Background::kMeanScale);
    const int16_t to = held[i] ? brighter : seen;
    mean[i] = uint16_t(from + product(int16_t(to - from), rate));
  }
}

}  // namespace markerless_mocap
