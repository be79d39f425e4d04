#pragma once

#include <algorithm>
#include <cstdint>
#include <opencv2/core/mat.hpp>

#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Squared difference of two images, over all channels, that noise hardly reaches, in variances.
constexpr double kNoiseVariances = 42;

/// Of two pixels. \param per_gain_a,per_gain_b the colours are multiplied by these
inline float squaredDistance(const uint8_t* a, float per_gain_a, const uint8_t* b, float per_gain_b,
                             int channels) {
  float sum = 0;
  for (int c = 0; c < channels; ++c) {
    const float off = a[c] * per_gain_a - b[c] * per_gain_b;
    sum += off * off;
  }
  return sum;
}

/// Two images of a place in which nothing has moved, and their light relative to the background's.
struct StillImages {
  const cv::Mat& now;
  double gain;
  const cv::Mat& then;
  double gain_then;

  /// What the background is to be at a value of pixel x, times Background::kMeanScale.
  uint16_t mean(int x, int y, int channel) const {
    const int at = x * now.channels() + channel;
    const double seen = (now.ptr(y)[at] / gain + then.ptr(y)[at] / gain_then) / 2;
    return toMeanScale(seen);
  }
};

/// Removes a place from the mask.
/// \param blur an image spreads the place over so many pixels around
/// \returns the place and what the blur reaches of what is not in the mask
BitMask takeOut(const BitMask& place, int blur, BitMask* mask);

}  // namespace markerless_mocap
