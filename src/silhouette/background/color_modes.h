#pragma once

#include <vector>

namespace markerless_mocap {

/// A mode of the colours of a pixel.
struct ColorMode {
  float mean[3];
  float sigma;  ///< standard deviation; root mean square over the channels
  int count;    ///< number of samples that belong to it
};

/// Largest squared distance of a sample from the mean of its mode. \param noise standard deviation
/// of a channel, grey levels
float colorReach(float noise, int channels);

/// The modes of a pixel's colours over time, the most frequent first. Each is the limit of a mean
/// shift with a flat kernel that starts at the densest sample. The samples of a mode are removed
/// before the next is searched.
/// \param samples `channels` floats per sample, one channel after the other, grey levels
/// \param min_sigma grey levels; the kernel's width depends on it and on the noise of the samples
std::vector<ColorMode> findColorModes(std::vector<float> samples, int channels, double min_sigma,
                                      int max_modes);

}  // namespace markerless_mocap
