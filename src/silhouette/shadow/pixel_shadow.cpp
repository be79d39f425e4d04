#include "silhouette/shadow/pixel_shadow.h"

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

__attribute__((always_inline)) inline float shadowRatio(float cross, float expected, float now,
                                                        const PixelShadowThresholds& limits) {
  const float ratio = cross / (expected + 1e-6f);
  const float off = now - ratio * cross;
  const float allowed = limits.squared_chroma * ratio * ratio * expected + limits.squared_noise;
  // Numbers instead of branches, so that the loop can be vectorised.
  const int is_shade = (ratio >= limits.min_brightness) & (ratio < 1) & (off < allowed);
  return ratio * 255 * float(is_shade);
}

MOCAP_VECTORISED void shadowsOfThree(const uint8_t* __restrict now0, const uint8_t* __restrict now1,
                                     const uint8_t* __restrict now2,
                                     const uint8_t* __restrict mean0,
                                     const uint8_t* __restrict mean1,
                                     const uint8_t* __restrict mean2, float gain,
                                     const PixelShadowThresholds& limits,
                                     uint8_t* __restrict ratio) {
  float shadow[64];
  for (int i = 0; i < 64; ++i) {
    const int n0 = now0[i], n1 = now1[i], n2 = now2[i];
    const int m0 = mean0[i], m1 = mean1[i], m2 = mean2[i];
    shadow[i] = shadowRatio(float(n0 * m0 + n1 * m1 + n2 * m2) * gain,
                            float(m0 * m0 + m1 * m1 + m2 * m2) * (gain * gain),
                            float(n0 * n0 + n1 * n1 + n2 * n2), limits);
  }
  for (int i = 0; i < 64; ++i) ratio[i] = uint8_t(int(shadow[i]));
}

MOCAP_VECTORISED void shadowsOfOne(const uint8_t* __restrict now, const uint8_t* __restrict mean,
                                   float gain, const PixelShadowThresholds& limits,
                                   uint8_t* __restrict ratio) {
  float shadow[64];
  for (int i = 0; i < 64; ++i) {
    const float n = now[i], m = mean[i] * gain;
    shadow[i] = shadowRatio(n * m, m * m, n * n, limits);
  }
  for (int i = 0; i < 64; ++i) ratio[i] = uint8_t(int(shadow[i]));
}

/// Clears ratios that are not selected, and adds the others to the columns.
/// \param chosen output, 255 for selected shadows, else 0
MOCAP_VECTORISED void addRatios(const uint8_t* __restrict selected, uint8_t* __restrict ratio,
                                uint8_t* __restrict chosen, ShadowColumns* __restrict columns) {
  for (int i = 0; i < ShadowColumns::kCols; ++i) {
    ratio[i] &= selected[i];
    chosen[i] = ratio[i] > 0 ? 255 : 0;
  }
  for (int i = 0; i < ShadowColumns::kCols; ++i) {
    const uint16_t half = uint16_t(ratio[i] >> 1);  // four squares fit 16 bits
    columns->count[i] = uint16_t(columns->count[i] + (chosen[i] & 1));
    columns->ratio[i] = uint16_t(columns->ratio[i] + half);
    columns->squares[i] = uint16_t(columns->squares[i] + half * half);
  }
}

MOCAP_VECTORISED void addColors(const uint8_t* __restrict values, const uint8_t* __restrict chosen,
                                uint16_t* __restrict sums) {
  for (int i = 0; i < ShadowColumns::kCols; ++i)
    sums[i] = uint16_t(sums[i] + (values[i] & chosen[i]));
}

}  // namespace

void shadowRatios(const uint8_t* const* now, const ModeRow& mode, int x, int channels, float gain,
                  const PixelShadowThresholds& limits, const uint8_t* selected, uint8_t* ratio,
                  ShadowColumns* columns) {
  const uint8_t* mean = mode.mean[0] + x;
  if (channels == 3)
    shadowsOfThree(now[0], now[1], now[2], mean, mode.mean[1] + x, mode.mean[2] + x, gain, limits,
                   ratio);
  else
    shadowsOfOne(now[0], mean, gain, limits, ratio);
  uint8_t chosen[ShadowColumns::kCols];
  addRatios(selected, ratio, chosen, columns);
  for (int c = 0; c < channels; ++c) {
    addColors(now[c], chosen, columns->now[c]);
    addColors(mode.mean[c] + x, chosen, columns->expected[c]);
  }
}

}  // namespace markerless_mocap
