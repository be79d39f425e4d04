#include "silhouette/background/background_learner.h"

#include <algorithm>
#include <cmath>

#include "numerics/large_memory.h"
#include "numerics/order_statistics.h"
#include "silhouette/background/color_modes.h"
#include "silhouette/background/light_gain.h"
#include "silhouette/background/one_color_row.h"

namespace markerless_mocap {
namespace {

constexpr size_t kMaxBytes = size_t(200) << 20;
constexpr int kMaxKept = 60, kMinKept = 9;

/// Number of images of this size that are kept, up to `frames`.
int affordableImages(const cv::Mat& image, int frames) {
  const int fitting = int(kMaxBytes / (image.total() * image.elemSize()));
  return std::min({frames, kMaxKept, std::max(kMinKept, fitting)});
}

/// A pixel with fewer modes than the background has repeats its first.
void store(const std::vector<ColorMode>& modes, int x, int y, Background* background) {
  for (int k = 0; k < background->modes(); ++k) {
    const ColorMode& mode = modes[size_t(k) < modes.size() ? k : 0];
    for (int c = 0; c < background->channels(); ++c)
      background->mean(k, y, c)[x] = toMeanScale(mode.mean[c]);
    background->sigma(k, y)[x] = toMeanScale(mode.sigma);
  }
}

}  // namespace

void BackgroundLearner::add(const cv::Mat& image) {
  const int64_t budget = affordableImages(image, frames_);
  if ((seen_ + 1) * budget / frames_ > seen_ * budget / frames_) {
    keep(image, size_t(budget));
    gains_.push_back(compensate_flicker_ ? float(estimateLightGain(image, kept_.front()).gain) : 1);
  }
  ++seen_;
}

/// In one piece: pages of images that are kept one by one cost more than all else here.
void BackgroundLearner::keep(const cv::Mat& image, size_t budget) {
  if (kept_.size() == budget) return kept_.push_back(image.clone());
  const size_t row = image.cols * image.elemSize(), bytes = row * image.rows;
  if (!pixels_) pixels_ = largeMemory(bytes * budget);
  kept_.emplace_back(image.rows, image.cols, image.type(), pixels_.get() + bytes * kept_.size());
  image.copyTo(kept_.back());
}

Background BackgroundLearner::learn(int modes, double min_sigma) const {
  const cv::Mat& first = kept_.front();
  const int channels = first.channels(), n = int(kept_.size());
  // The background gets the median light of all kept images, not the light of the first.
  const float expected = medianOf(gains_);
  Background background(first.size(), channels, modes);
  OneColorRow row(first.cols, channels, colorReach(float(min_sigma), channels));
  std::vector<float> samples(size_t(n) * channels);
  for (int y = 0; y < first.rows; ++y) {
    row.clear();
    for (int i = 0; i < n; ++i) row.add(kept_[i].ptr(y), expected / gains_[i]);
    row.finish();
    row.store(y, &background);
    for (int x = 0; x < first.cols; ++x) {
      if (row.hasOneColor(x)) continue;
      for (int i = 0; i < n; ++i) row.copySample(i, x, &samples[size_t(i) * channels]);
      store(findColorModes(samples, channels, min_sigma, modes), x, y, &background);
    }
  }
  return background;
}

}  // namespace markerless_mocap
