#include "region/colors/color_histogram.h"

#include <cmath>

namespace markerless_mocap {
namespace {

constexpr uint32_t kMinCount = 12;       // samples
constexpr float kBlurSigma_bins = 0.7f;  // bridges bins that few samples leave empty

/// Blurs along one axis with the weights of the neighbours one bin away.
/// \param step distance of neighbours in `values` \param length bins along the axis
void blur(std::vector<float>& values, int step, int length) {
  const float side = std::exp(-0.5f / (kBlurSigma_bins * kBlurSigma_bins));
  const float middle = 1 / (1 + 2 * side), next = side * middle;
  std::vector<float> out(values.size());
  for (int block = 0; block < int(values.size()); block += step * length)
    for (int along = 0; along < length; ++along) {
      const float* from = &values[size_t(block + along * step)];
      float* to = &out[size_t(block + along * step)];
      const int below = along > 0 ? -step : 0, above = along + 1 < length ? step : 0;
      const float of_below = below ? next : 0, of_above = above ? next : 0;
      for (int i = 0; i < step; ++i)
        to[i] = middle * from[i] + of_below * from[i + below] + of_above * from[i + above];
    }
  values = std::move(out);
}

}  // namespace

void ColorHistogram::learn(const std::vector<uint32_t>& counts, float rate) {
  uint32_t total = 0;
  for (const uint32_t count : counts) total += count;
  if (total < kMinCount) return;
  std::vector<float> now(counts.size());
  for (size_t i = 0; i < counts.size(); ++i) now[i] = float(counts[i]) / float(total);
  blur(now, 1, ColorBins::kChroma);
  blur(now, ColorBins::kChroma, ColorBins::kChroma);
  blur(now, ColorBins::kChroma * ColorBins::kChroma, ColorBins::kLightness);
  if (empty()) {
    probability_ = std::move(now);
    return;
  }
  for (size_t i = 0; i < now.size(); ++i) probability_[i] += rate * (now[i] - probability_[i]);
}

}  // namespace markerless_mocap
