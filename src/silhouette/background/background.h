#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// One row of a mode (expected colour) of each pixel.
struct ModeRow {
  std::array<const uint8_t*, 3> mean;  ///< grey levels, one pointer per channel
  /// weight * weight_unit is Background::kLimit * kWeightScale divided by the threshold in grey
  /// levels; 0 right of the image.
  const uint8_t* weight;
  int16_t weight_unit;
};

/// Background model: for each pixel of the empty scene one or several expected colours (modes), and
/// how far the image may differ from them. Fixed point; planar by row; padded to whole words of 64
/// pixels.
class Background {
 public:
  static constexpr int kMeanScale = 128;  ///< a mean is kMeanScale * grey level
  static constexpr int kMaxModes = 3;     ///< maximum number of modes of a pixel
  static constexpr int kLimit = 60;       ///< the threshold, in units of scaled distance
  /// Of kLimit divided by the threshold in grey levels.
  static constexpr double kWeightScale = 512;

  Background() = default;
  Background(const cv::Size& size, int channels, int modes);

  const cv::Size& size() const { return size_; }
  int channels() const { return channels_; }
  int modes() const { return modes_; }
  int type() const { return CV_MAKETYPE(CV_8U, channels_); }
  bool empty() const { return mean_.empty(); }
  int stride() const { return stride_; }

  /// Means of row y, channel c: `stride()` values; those right of the image are 0.
  uint16_t* mean(int mode, int y, int c) {
    return &mean_[offset(mode, y) * channels_ + c * stride_];
  }
  const uint16_t* mean(int mode, int y, int c) const {
    return &mean_[offset(mode, y) * channels_ + c * stride_];
  }
  /// Standard deviations of row y over all channels, in kMeanScale * grey level.
  uint16_t* sigma(int mode, int y) { return &sigma_[offset(mode, y)]; }
  const uint16_t* sigma(int mode, int y) const { return &sigma_[offset(mode, y)]; }
  /// Row y's means in grey levels and its weights, as bytes. Each pixel of each image is compared
  /// with these; that loop is limited by memory, so they are small.
  ModeRow quantised(int mode, int y) const;
  /// Bytes from one quantised row to the next.
  ptrdiff_t quantisedStep() const { return ptrdiff_t(stride_) * (channels_ + 1); }
  /// Call this after a change of row y's means.
  void updateQuantised(int mode, int y);

  /// Median standard deviation of a pixel over all channels, at least `min_sigma`, grey levels.
  double noise() const { return noise_; }

  /// Computes the weights, the noise and the quantised means from means and standard deviations.
  void setThreshold(double threshold_sigmas, double min_sigma);

  /// Pixels whose background is not known: their colours mean nothing. Empty: all are known.
  const BitMask& unknown() const { return unknown_; }
  bool hasUnknown() const { return unknown_.rows() > 0; }
  void setUnknown(BitMask unknown) { unknown_ = std::move(unknown); }
  bool isUnknown(int x, int y) const { return hasUnknown() && unknown_.at(x, y); }
  /// Only if some pixels have been unknown before.
  void setUnknown(int x, int y, bool unknown) { unknown_.fill(y, x, x, unknown); }

  /// Unknown pixels whose colours are those of somebody who keeps still: as long as the image shows
  /// them, the person is there. Not part of a file: by the time it is read, the person has gone.
  const BitMask& person() const { return person_; }
  /// \param person some of the unknown pixels
  void setPerson(BitMask person) { person_ = std::move(person); }

  /// Throws std::invalid_argument with a message that names the file if it cannot be written.
  void save(const std::string& path) const;
  /// The weights are not set: call setThreshold(). Throws std::invalid_argument with a message that
  /// names the file if it is missing or holds no background.
  static Background load(const std::string& path);

 private:
  size_t offset(int mode, int y) const { return (size_t(mode) * size_.height + y) * stride_; }
  size_t quantisedOffset(int mode, int y) const { return offset(mode, y) * (channels_ + 1); }

  cv::Size size_;
  int channels_ = 0, modes_ = 0, stride_ = 0;
  double noise_ = 0;
  int weight_unit_ = 1;
  std::vector<uint16_t> mean_, sigma_;
  std::vector<uint8_t> quantised_;  ///< per row: the means, channel by channel, then the weights
  BitMask unknown_, person_;
};

/// A grey level as Background has it, limited to 0 to 255. In the loops of kernels, so that it must
/// be part of each form of them.
template <class Real>
__attribute__((always_inline)) inline uint16_t toMeanScale(Real grey) {
  const Real within = grey < 0 ? 0 : grey > 255 ? 255 : grey;
  return uint16_t(int(within * Background::kMeanScale + Real(0.5)));
}

}  // namespace markerless_mocap
