#pragma once

#include <vector>

namespace markerless_mocap {

/// A colour that a pixel often has.
struct ColorMode {
  float mean[3];
  float sigma;  ///< standard deviation, root mean square over the channels
  int count;    ///< samples that belong to it
};

/// The modes of a pixel's colours over time, the most frequent first: each is where a mean shift
/// with a flat kernel, begun at the densest sample, comes to rest; its samples are then taken away.
/// \param samples channel after channel, `channels` floats a sample, grey levels
/// \param min_sigma grey levels; with the samples' own noise it gives the kernel's width
std::vector<ColorMode> findColorModes(std::vector<float> samples, int channels, double min_sigma,
                                      int most);

}  // namespace markerless_mocap
