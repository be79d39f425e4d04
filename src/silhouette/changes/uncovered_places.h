#pragma once

#include <cstddef>
#include <opencv2/core/mat.hpp>

#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Places that a person or a thing covered, standing still, while the background was learned, and
/// has left since. The mask shows a ghost there: its outline is an edge in the background, and none
/// in the image. Such a place becomes background as it is seen now, once nothing moves in it.
class UncoveredPlaces {
 public:
  /// Call this with each image.
  /// \param gain light of the image relative to the background's
  /// \param mask the foreground and what is unknown; what has become background is removed
  /// \returns number of pixels that have become background
  size_t update(const cv::Mat& image, double gain, Background* background, BitMask* mask);
  /// The light has changed.
  void clear() { previous_.release(); }

 private:
  /// Pixels of the foreground in which nothing has moved since the last check.
  BitMask stillPart(const cv::Mat& image, double gain, const Background& background,
                    const BitMask& mask) const;

  int images_ = 0;
  cv::Mat previous_;  ///< image of the last check; empty: nothing was suspect
  double previous_gain_ = 1;
};

}  // namespace markerless_mocap
