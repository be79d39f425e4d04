#pragma once

#include "silhouette/background/subtractor.h"

namespace markerless_mocap {

/// Where somebody kept still while the background was learned. Their outline was a guess: limbs
/// that it lacked are part of the background, and foreground since they have gone.
class LeftPlace {
 public:
  /// \param found of the next image
  /// \return whether its images show by now that the person has gone
  bool isLeft(const Extraction& found);
  /// What the person may have been is unknown from now on.
  /// \param outline of the person as guessed
  void hide(const BitMask& outline);
  bool isHidden() const { return !place_.empty(); }
  /// Another background has been learned.
  void forget() { *this = LeftPlace(); }
  /// \param mask SilhouetteMask values; those of a person there become unknown
  /// \pre isHidden()
  void removeGhost(cv::Mat& mask) const;

 private:
  int run_ = 0;     ///< images in a row that show it
  cv::Rect place_;  ///< empty if nothing is hidden
};

}  // namespace markerless_mocap
