#include "silhouette/background/one_color_row.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "numerics/simd_clones.h"
#include "silhouette/background/row_kernels.h"

namespace markerless_mocap {
namespace {

MOCAP_VECTORISED void addSample(const uint8_t* __restrict now, float light,
                                const uint8_t* __restrict first, float first_light, int n,
                                float* __restrict sum, float* __restrict squares) {
  for (int i = 0; i < n; ++i) {
    const float value = float(now[i]) * light, off = value - float(first[i]) * first_light;
    sum[i] += value;
    squares[i] += off * off;
  }
}

MOCAP_VECTORISED void divide(float divisor, int n, float* __restrict value) {
  for (int i = 0; i < n; ++i) value[i] /= divisor;
}

MOCAP_VECTORISED void addDistance(const uint8_t* __restrict now, float light,
                                  const float* __restrict mean, int n, float* __restrict apart) {
  for (int i = 0; i < n; ++i) {
    const float off = float(now[i]) * light - mean[i];
    apart[i] += off * off;
  }
}

MOCAP_VECTORISED void keepLarger(const float* __restrict other, int n, float* __restrict value) {
  for (int i = 0; i < n; ++i) value[i] = other[i] > value[i] ? other[i] : value[i];
}

/// Of squares of distances from the first sample, those of the mean from it.
MOCAP_VECTORISED void removeShift(const uint8_t* __restrict first, float light,
                                  const float* __restrict mean, float count, int n,
                                  float* __restrict squares) {
  for (int i = 0; i < n; ++i) {
    const float off = mean[i] - float(first[i]) * light;
    squares[i] -= count * off * off;
  }
}

MOCAP_VECTORISED void toFixed(const float* __restrict grey, int n, uint16_t* __restrict out) {
  for (int i = 0; i < n; ++i) out[i] = toMeanScale(grey[i]);
}

MOCAP_VECTORISED void toDeviations(const float* __restrict squares, float degrees_of_freedom, int n,
                                   uint16_t* __restrict out) {
  for (int i = 0; i < n; ++i) {
    const float variance = squares[i] / degrees_of_freedom;
    out[i] = toMeanScale(std::sqrt(variance > 0 ? variance : 0));
  }
}

}  // namespace

OneColorRow::OneColorRow(int width, int channels, float reach)
    : width_(width),
      channels_(channels),
      reach_(reach),
      mean_(size_t(channels) * width),
      squares_(width),
      apart_(width),
      far_(width) {}

void OneColorRow::clear() {
  images_ = 0;
  lights_.clear();
}

void OneColorRow::add(const uint8_t* row, float light) {
  const size_t bytes = size_t(width_) * channels_;
  planes_.resize(std::max(planes_.size(), bytes * (images_ + 1)));
  uint8_t* planes = &planes_[bytes * images_];
  if (channels_ == 3)
    deinterleaveBgr(row, width_, width_, planes);
  else
    std::memcpy(planes, row, bytes);
  lights_.push_back(light);
  ++images_;
}

void OneColorRow::finish() {
  std::fill(mean_.begin(), mean_.end(), 0.0f);
  std::fill(squares_.begin(), squares_.end(), 0.0f);
  std::fill(far_.begin(), far_.end(), 0.0f);
  for (int i = 0; i < images_; ++i)
    for (int c = 0; c < channels_; ++c)
      addSample(plane(i, c), lights_[i], plane(0, c), lights_[0], width_,
                &mean_[size_t(c) * width_], squares_.data());
  divide(float(images_), channels_ * width_, mean_.data());
  for (int i = 0; i < images_; ++i) {
    std::fill(apart_.begin(), apart_.end(), 0.0f);
    for (int c = 0; c < channels_; ++c)
      addDistance(plane(i, c), lights_[i], &mean_[size_t(c) * width_], width_, apart_.data());
    keepLarger(apart_.data(), width_, far_.data());
  }
}

void OneColorRow::store(int y, Background* background) const {
  const float degrees_of_freedom = float(channels_) * float(std::max(1, images_ - 1));
  std::vector<float> squares = squares_;
  for (int c = 0; c < channels_; ++c) {
    const float* mean = &mean_[size_t(c) * width_];
    removeShift(plane(0, c), lights_[0], mean, float(images_), width_, squares.data());
    toFixed(mean, width_, background->mean(0, y, c));
  }
  toDeviations(squares.data(), degrees_of_freedom, width_, background->sigma(0, y));
  for (int k = 1; k < background->modes(); ++k) {
    for (int c = 0; c < channels_; ++c)
      std::copy_n(background->mean(0, y, c), width_, background->mean(k, y, c));
    std::copy_n(background->sigma(0, y), width_, background->sigma(k, y));
  }
}

void OneColorRow::copySample(int i, int x, float* sample) const {
  for (int c = 0; c < channels_; ++c) sample[c] = float(plane(i, c)[x]) * lights_[i];
}

}  // namespace markerless_mocap
