#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace markerless_mocap {

/// One row of a usual colour of each pixel.
struct ModeRow {
  std::array<const uint8_t*, 3> mean;  ///< grey levels, a channel each
  /// Times weight_unit: Background::kLimit * kWeightScale over the threshold in grey levels; 0
  /// right of the image.
  const uint8_t* weight;
  int16_t weight_unit;
};

/// What each pixel of the empty scene looks like: one or several usual colours and how far the
/// image may be from them. Fixed point, planar by row, padded to whole words of 64 pixels.
class Background {
 public:
  static constexpr int kMeanScale = 128;       ///< of a mean's grey level
  static constexpr int kMostModes = 3;         ///< usual colours of a pixel
  static constexpr int kLimit = 60;            ///< the threshold in units of scaled distance
  static constexpr double kWeightScale = 512;  ///< of kLimit over the threshold in grey levels

  Background() = default;
  Background(const cv::Size& size, int channels, int modes);

  const cv::Size& size() const { return size_; }
  int channels() const { return channels_; }
  int modes() const { return modes_; }
  int type() const { return CV_MAKETYPE(CV_8U, channels_); }
  bool empty() const { return mean_.empty(); }
  int stride() const { return stride_; }

  /// Means of row y, channel c; `stride()` values of which those right of the image are 0.
  uint16_t* mean(int mode, int y, int c) {
    return &mean_[offset(mode, y) * channels_ + c * stride_];
  }
  const uint16_t* mean(int mode, int y, int c) const {
    return &mean_[offset(mode, y) * channels_ + c * stride_];
  }
  /// Standard deviations of row y, of all channels together, kMeanScale to a grey level.
  uint16_t* sigma(int mode, int y) { return &sigma_[offset(mode, y)]; }
  const uint16_t* sigma(int mode, int y) const { return &sigma_[offset(mode, y)]; }
  /// What every pixel of every image is compared with, in a byte each, as memory is what that loop
  /// waits for: row y's means in grey levels, and its weights.
  ModeRow coarse(int mode, int y) const;
  /// From a row of those to the next, bytes.
  ptrdiff_t coarseStep() const { return ptrdiff_t(stride_) * (channels_ + 1); }
  /// Row y's means have changed.
  void renewCoarse(int mode, int y);

  /// Usual standard deviation of a pixel, all channels together, at least `min_sigma`, grey levels.
  double noise() const { return noise_; }

  /// Makes the weights, the noise and the coarse means from the standard deviations.
  void setThreshold(double threshold_sigmas, double min_sigma);

  /// Throws std::invalid_argument, in one sentence that names the file, if it cannot be written.
  void save(const std::string& path) const;
  /// Without weights. Throws std::invalid_argument, in one sentence that names the file, if it is
  /// missing or no background.
  static Background load(const std::string& path);

 private:
  size_t offset(int mode, int y) const { return (size_t(mode) * size_.height + y) * stride_; }
  size_t coarseOffset(int mode, int y) const { return offset(mode, y) * (channels_ + 1); }

  cv::Size size_;
  int channels_ = 0, modes_ = 0, stride_ = 0;
  double noise_ = 0;
  int weight_unit_ = 1;
  std::vector<uint16_t> mean_, sigma_;
  std::vector<uint8_t> coarse_;  ///< row after row: a mean per channel, then the weights
};

}  // namespace markerless_mocap
