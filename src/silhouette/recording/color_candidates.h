#pragma once

#include <array>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// A colour that a pixel shows in part of the recording.
struct ColorCandidate {
  cv::Vec3f color;  ///< grey levels, BGR
  float share = 0;  ///< fraction of the samples that have it
};

/// The candidates for the background of one pixel.
struct PixelCandidates {
  static constexpr int kMax = 6;
  std::array<ColorCandidate, kMax> colors;
  int count = 0;

  const ColorCandidate* begin() const { return colors.data(); }
  const ColorCandidate* end() const { return colors.data() + count; }
};

/// The candidates of all pixels, row by row: up to three clusters of all samples, the largest
/// first, then up to three of those samples in which nothing moves at the pixel.
std::vector<PixelCandidates> findCandidates(const SceneSamples& samples);

}  // namespace markerless_mocap
