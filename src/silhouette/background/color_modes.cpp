#include "silhouette/background/color_modes.h"

#include <algorithm>
#include <cmath>

#include "numerics/order_statistics.h"

namespace markerless_mocap {
namespace {

/// Width of the mean shift kernel, in standard deviations of the noise.
constexpr float kKernelSigmas = 4;
/// Fraction of the samples that a further mode needs; people who cross the scene have less.
constexpr double kMinModeFraction = 0.3;
constexpr int kMaxShifts = 10;

float squaredDistance(const float* a, const float* b, int channels) {
  float sum = 0;
  for (int c = 0; c < channels; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

class Samples {
 public:
  Samples(std::vector<float> values, int channels)
      : values_(std::move(values)), channels_(channels) {}

  int count() const { return int(values_.size()) / channels_; }
  const float* at(int i) const { return &values_[size_t(i) * channels_]; }

  /// Mean and standard deviation of the samples within the square root of `reach` of a colour.
  ColorMode meanNear(const float* center, float reach) const {
    ColorMode mode{{}, 0, 0};
    float squares = 0;
    for (int i = 0; i < count(); ++i) {
      if (squaredDistance(at(i), center, channels_) > reach) continue;
      for (int c = 0; c < channels_; ++c) {
        mode.mean[c] += at(i)[c];
        squares += (at(i)[c] - center[c]) * (at(i)[c] - center[c]);
      }
      ++mode.count;
    }
    float shift = 0;
    for (int c = 0; c < channels_; ++c) {
      mode.mean[c] /= float(std::max(1, mode.count));
      shift += (mode.mean[c] - center[c]) * (mode.mean[c] - center[c]);
    }
    const float degrees_of_freedom = float(channels_) * std::max(1, mode.count - 1);
    mode.sigma = std::sqrt(std::max(0.0f, squares - mode.count * shift) / degrees_of_freedom);
    return mode;
  }

  int densest(float reach) const {
    int best = 0, best_count = 0;
    for (int i = 0; i < count(); ++i) {
      int near = 0;
      for (int j = 0; j < count(); ++j) near += squaredDistance(at(i), at(j), channels_) <= reach;
      if (near > best_count) {
        best_count = near;
        best = i;
      }
    }
    return best;
  }

  void remove(const float* center, float reach) {
    std::vector<float> rest;
    for (int i = 0; i < count(); ++i)
      if (squaredDistance(at(i), center, channels_) > reach)
        rest.insert(rest.end(), at(i), at(i) + channels_);
    values_ = std::move(rest);
  }

  /// Noise per channel (standard deviation), from the median step from one sample to the next.
  float noise() const {
    std::vector<float> steps;
    for (int i = 1; i < count(); ++i) steps.push_back(squaredDistance(at(i), at(i - 1), channels_));
    // Median of chi squared with n degrees of degrees_of_freedom: about n (1 - 2 / (9 n))^3; a step
    // has twice the variance of a sample.
    const float n = float(channels_), shrink = 1 - 2 / (9 * n);
    return std::sqrt(medianAmong(steps) / (2 * n * shrink * shrink * shrink));
  }

 private:
  std::vector<float> values_;
  int channels_;
};

ColorMode shifted(const Samples& samples, int start, float reach) {
  ColorMode mode = samples.meanNear(samples.at(start), reach);
  for (int i = 0; i < kMaxShifts; ++i) {
    const ColorMode next = samples.meanNear(mode.mean, reach);
    if (next.count <= mode.count) break;
    mode = next;
  }
  return mode;
}

}  // namespace

float colorReach(float noise, int channels) {
  return kKernelSigmas * kKernelSigmas * noise * noise * float(channels) / 2;
}

std::vector<ColorMode> findColorModes(std::vector<float> values, int channels, double min_sigma,
                                      int max_modes) {
  Samples samples(std::move(values), channels);
  const int all = samples.count();
  const ColorMode whole = samples.meanNear(samples.at(0), 1e30f);
  float reach = colorReach(float(min_sigma), channels);
  if (samples.meanNear(whole.mean, reach).count == all) return {whole};
  reach = std::max(reach, colorReach(samples.noise(), channels));
  if (samples.meanNear(whole.mean, reach).count == all) return {whole};
  std::vector<ColorMode> modes;
  while (int(modes.size()) < max_modes && samples.count() > 0) {
    const ColorMode mode = shifted(samples, samples.densest(reach), reach);
    if (!modes.empty() && mode.count < std::max(2.0, kMinModeFraction * all)) break;
    modes.push_back(mode);
    samples.remove(mode.mean, reach);
  }
  std::stable_sort(modes.begin(), modes.end(),
                   [](const ColorMode& a, const ColorMode& b) { return a.count > b.count; });
  return modes;
}

}  // namespace markerless_mocap
