#pragma once

#include <opencv2/core/mat.hpp>
#include <optional>

#include "silhouette/background/background.h"
#include "silhouette/background/light_gain.h"
#include "silhouette/bits/bit_mask.h"

namespace markerless_mocap {

/// Notices that a lamp was switched: many pixels change from one image to the next, each place by a
/// factor of its own. The background is then lit anew. The one before is remembered, as lamps are
/// also switched back, and as pictures that are blurred or zoomed for a while, which no light
/// explains, spoil it; and where one change follows another, as when a camera sees bands of light
/// or looks for its focus, that before all of them. They are taken back as soon as the image shows
/// them.
class LightSwitch {
 public:
  /// \param light of the image relative to the background
  /// \param person mask of the image before
  /// \returns whether the background was changed
  bool update(const cv::Mat& image, const LightGain& light, const BitMask& person,
              Background* background);

 private:
  /// A background, and the fraction of pixels that one gain explained while it held.
  struct Light {
    Background background;
    double usual;
  };

  bool takeBack(const cv::Mat& image, double agreeing, Background* background);
  bool isShown(const cv::Mat& image, const std::optional<Light>& light, double agreeing) const;
  void exchange(Light* light, Background* background);
  void remember(Background before, double usual);

  double usual_ = -1;  ///< fraction of pixels that one gain explains; below 0: no image yet
  double last_ = -1;   ///< the same of the last image
  int unchanged_ = 0;  ///< images since the last change
  std::optional<Light> other_;  ///< before the last change
  std::optional<Light> first_;  ///< before the changes that came soon after one another
};

/// The background in the light of an image. Its light is estimated in blocks; nearby blocks give it
/// where the person is. Returns false, and changes nothing, if light does not explain the image, or
/// if one gain explains it as well. \param gain light of the image relative to the background's
/// \param person the image does not show the background here
bool relight(const cv::Mat& image, double gain, const BitMask& person, Background* background);

}  // namespace markerless_mocap
