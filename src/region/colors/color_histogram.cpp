#include "region/colors/color_histogram.h"

#include <cmath>

namespace markerless_mocap {
namespace {

constexpr uint32_t kMinCount = 12;       // samples
constexpr float kBlurSigma_bins = 0.7f;  // bridges bins that few samples leave empty

/// Blurs along one axis with the weights of the neighbours one bin away.
void blur(std::vector<float>& values, int step, int length) {
  const float side = std::exp(-0.5f / (kBlurSigma_bins * kBlurSigma_bins));
  const float sum = 1 + 2 * side;
  std::vector<float> out(values.size());
  for (int i = 0; i < int(values.size()); ++i) {
    const int at = i / step % length;
    const float below = at > 0 ? values[size_t(i - step)] : 0.f;
    const float above = at + 1 < length ? values[size_t(i + step)] : 0.f;
    out[size_t(i)] = (values[size_t(i)] + side * (below + above)) / sum;
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
