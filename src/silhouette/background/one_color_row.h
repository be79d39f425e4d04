#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// The pixels of a row that show one colour in all images, as nearly all do in an empty room: found
/// for the whole row at once, much faster than by findColorModes(), which gives the same for them.
class OneColorRow {
 public:
  /// \param reach largest squared distance of a sample from the mean, see colorReach() in
  /// color_modes.h
  OneColorRow(int width, int channels, float reach);

  /// Forgets the images so far.
  void clear();
  /// \param row `width` pixels of `channels` bytes \param light what they are multiplied by
  void add(const uint8_t* row, float light);
  /// Computes means and distances of the images added.
  void finish();
  bool hasOneColor(int x) const { return far_[x] <= reach_; }
  /// Writes the mean and the standard deviation of every pixel, also of those with several colours,
  /// to row y of each mode.
  void store(int y, Background* background) const;
  /// Sample i of a pixel: `channels` floats.
  void copySample(int i, int x, float* sample) const;

 private:
  const uint8_t* plane(int image, int channel) const {
    return &planes_[(size_t(image) * channels_ + channel) * width_];
  }

  int width_, channels_, images_ = 0;
  float reach_;
  std::vector<uint8_t> planes_;  ///< by image and channel
  std::vector<float> lights_;
  std::vector<float> mean_;     ///< by channel
  std::vector<float> squares_;  ///< of the distances from the first sample
  std::vector<float> apart_, far_;
};

}  // namespace markerless_mocap
