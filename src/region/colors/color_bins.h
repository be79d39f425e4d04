#pragma once

#include <array>
#include <cstdint>
#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Bins of colours in CIE Lab: fewer of lightness than of the two chroma axes, which are stretched
/// over the range that ordinary scenes have.
class ColorBins {
 public:
  static constexpr int kLightness = 8, kChroma = 16;
  static constexpr int kCount = kLightness * kChroma * kChroma;
  static const ColorBins& instance();
  /// \param bgr CV_8UC3; returns CV_16UC1 of the same size
  cv::Mat of(const cv::Mat& bgr) const;

 private:
  ColorBins();
  static constexpr int kBits = 5;  // of each channel that are looked at
  std::array<uint16_t, 1 << (3 * kBits)> bin_;
};

}  // namespace markerless_mocap
