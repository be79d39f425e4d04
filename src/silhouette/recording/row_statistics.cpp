#include "silhouette/recording/row_statistics.h"

#include <algorithm>
#include <cmath>

#include "numerics/simd_clones.h"

namespace markerless_mocap {
namespace {

constexpr float kReach = 20;    ///< of a sample from the background's colour, grey levels
constexpr int kFewSamples = 3;  ///< with fewer, the deviation is not measured
constexpr float kUsualSigma = 4;

/// Planes of a row, one for each channel.
struct Sums {
  float *squares, *counts;
  float* of_channel[3];
};

MOCAP_VECTORISED void addColor(const uint8_t* __restrict row, float gain, int n,
                               const float* __restrict expected, const Sums& sums) {
  const float *e0 = expected, *e1 = expected + n, *e2 = e1 + n;
  float* __restrict squares = sums.squares, * __restrict counts = sums.counts;
  float* __restrict s0 = sums.of_channel[0], * __restrict s1 = sums.of_channel[1], * __restrict s2 = sums.of_channel[2];
  for (ptrdiff_t x = 0; x < n; ++x) {
    const float d0 = row[3 * x] / gain - e0[x], d1 = row[3 * x + 1] / gain - e1[x],
                d2 = row[3 * x + 2] / gain - e2[x];
    const float distance = d0 * d0 + d1 * d1 + d2 * d2;
    const float shown = distance > kReach * kReach ? 0.f : 1.f;
    counts[x] += shown;
    squares[x] += shown * distance;
    s0[x] += shown * d0;
    s1[x] += shown * d1;
    s2[x] += shown * d2;
  }
}

MOCAP_VECTORISED void addGrey(const uint8_t* __restrict row, float gain, int n,
                              const float* __restrict expected, const Sums& sums) {
  float* __restrict squares = sums.squares, * __restrict counts = sums.counts, * __restrict sum = sums.of_channel[0];
  for (int x = 0; x < n; ++x) {
    const float d = row[x] / gain - expected[x];
    const float shown = d * d > kReach * kReach ? 0.f : 1.f;
    counts[x] += shown;
    squares[x] += shown * d * d;
    sum[x] += shown * d;
  }
}

/// Adds the offset of the samples' mean to the expected colours of a channel, and its square to
/// `shifts`.
MOCAP_VECTORISED void meanOf(const float* __restrict expected, const float* __restrict sums,
                             const float* __restrict counts, int n, float* __restrict shifts,
                             uint16_t* __restrict mean) {
  for (int x = 0; x < n; ++x) {
    const float offset = sums[x] / std::max(1.f, counts[x]);
    mean[x] = toMeanScale(std::max(0.f, expected[x] + offset));
    shifts[x] += offset * offset;
  }
}

MOCAP_VECTORISED void sigmaOf(const float* __restrict squares, const float* __restrict counts,
                              const float* __restrict shifts, int channels, int n,
                              uint16_t* __restrict sigma) {
  for (int x = 0; x < n; ++x) {
    const float rest = std::max(0.0f, squares[x] - counts[x] * shifts[x]);
    const float measured = std::sqrt(rest / (channels * std::max(1.f, counts[x] - 1)));
    sigma[x] = toMeanScale(counts[x] < kFewSamples ? kUsualSigma : measured);
  }
}

}  // namespace

RowStatistics::RowStatistics(const SceneSamples& samples)
    : samples_(samples),
      width_(samples.image_size.width),
      channels_(samples.image_channels),
      expected_(size_t(width_) * channels_),
      sums_(expected_.size()),
      squares_(width_),
      counts_(width_),
      shifts_(width_) {}

void RowStatistics::measure(int y, const cv::Vec3f* expected, Background& background) {
  for (int c = 0; c < channels_; ++c)
    for (int x = 0; x < width_; ++x) expected_[size_t(c) * width_ + x] = expected[x][c];
  for (std::vector<float>* sums : {&sums_, &squares_, &counts_, &shifts_})
    std::fill(sums->begin(), sums->end(), 0.f);
  const Sums sums{squares_.data(),
                  counts_.data(),
                  {&sums_[0], &sums_[size_t(width_) * (channels_ / 2)],
                   &sums_[size_t(width_) * (channels_ - 1)]}};
  for (int i = 0; i < samples_.count(); ++i) {
    if (samples_.images[i].empty()) continue;
    const uint8_t* row = samples_.images[i].ptr(y);
    (channels_ == 3 ? addColor : addGrey)(row, samples_.gains[i], width_, expected_.data(), sums);
  }
  for (int c = 0; c < channels_; ++c)
    meanOf(&expected_[size_t(c) * width_], &sums_[size_t(c) * width_], counts_.data(), width_,
           shifts_.data(), background.mean(0, y, c));
  sigmaOf(squares_.data(), counts_.data(), shifts_.data(), channels_, width_,
          background.sigma(0, y));
}

}  // namespace markerless_mocap
