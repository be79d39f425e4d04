#pragma once

#include <deque>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/background/background.h"
#include "silhouette/bits/bit_mask.h"
#include "silhouette/bits/mask_runs.h"

namespace markerless_mocap {

/// Things that are brought into the scene, moved or taken away: parts of the foreground, apart from
/// all others, in which nothing moves for about twenty images while something else does. They
/// become background. A person who is alone in the image never does, however still. When some of
/// the old background shows again, all that was covered is background as before. Pixels of an
/// unknown background are parts of the foreground; those that become background are known.
class StillObjects {
 public:
  /// Call this with each image.
  /// \param gain light of the image relative to the background's
  /// \param mask the foreground and what is unknown; what has become background is removed
  /// \returns true if pixels have become known or unknown: thresholds must be set again
  bool update(const cv::Mat& image, double gain, Background* background, BitMask* mask);
  /// Forgets what was covered, as the light has changed; the background stays as it is.
  void clear();

 private:
  struct Pixel {
    int x, y;
    uint16_t before[3];  ///< mean of the background, in Background::kMeanScale
    bool was_unknown;
  };
  using Component = std::vector<MaskRun>;
  using Object = std::vector<Pixel>;

  struct Motion {
    int area = 0, changed = 0;
  };
  /// Compares the image with that of the last check.
  void compare(const std::vector<Component>& components, const cv::Mat& image, double gain,
               Background* background, BitMask* mask);
  Motion motionOf(const Component& component, const cv::Mat& image, double gain) const;
  /// At the last checks.
  bool wasStill(const Component& component) const;
  /// Makes the place background as the image shows it.
  void absorb(const BitMask& place, const cv::Mat& image, double gain, Background* background);
  /// Whether some of what was behind the object shows.
  bool isGone(const Object& object, const cv::Mat& image, double gain,
              const Background& background) const;
  void restore(const Object& object, Background* background);
  void restoreUncovered(const cv::Mat& image, double gain, Background* background);

  int images_ = 0;
  double noise_ = 0;
  bool unknown_changed_ = false;  ///< in the last update
  cv::Mat previous_;              ///< image of the last check, in the rows of the foreground
  double previous_gain_ = 1;      ///< its light
  std::deque<BitMask> still_;     ///< still components of the last checks
  std::vector<Object> objects_;
};

}  // namespace markerless_mocap
