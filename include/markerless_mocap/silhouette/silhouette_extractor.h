#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "markerless_mocap/silhouette/silhouette_options.h"

namespace markerless_mocap {

/// kStale: masks still come, but for a while the background has explained too little of the image
/// (the camera was moved, the room rearranged, the light switched): it should be learned anew.
enum class SilhouetteState { kLearning, kReady, kStale };

/// Result of one frame.
struct SilhouetteResult {
  SilhouetteState state = SilhouetteState::kLearning;
  cv::Mat mask;                 ///< CV_8UC1, 0 | 255, empty while learning
  double changed_fraction = 0;  ///< of the pixels, unlike the background, shadows included
  double light_gain = 1;        ///< brightness relative to the background's
};

/// Background subtraction of one camera: a background model per pixel, a shadow test, clean-up.
/// Not thread-safe; one object per camera.
class SilhouetteExtractor {
 public:
  /// Throws std::invalid_argument as SilhouetteOptions::validate().
  explicit SilhouetteExtractor(const SilhouetteOptions& options);
  ~SilhouetteExtractor();
  SilhouetteExtractor(SilhouetteExtractor&&) noexcept;
  SilhouetteExtractor& operator=(SilhouetteExtractor&&) noexcept;

  /// \param image CV_8UC1 or CV_8UC3 (BGR), same size and type every time; throws
  ///   std::invalid_argument otherwise. The first `background_frames` images are learned from:
  ///   the empty scene, or one that people cross.
  SilhouetteResult update(const cv::Mat& image);
  /// Back to how it began: the loaded background as it was loaded, or learning.
  void reset();
  /// Forgets the background, also a loaded one; learning starts anew.
  void relearn();
  int framesLearned() const;

  /// Throws std::invalid_argument, in one sentence that names the file, while learning, if it
  /// cannot be written, or if `model` is OpenCV's, which cannot be saved.
  void saveBackground(const std::string& path) const;
  /// Replaces learning. Throws std::invalid_argument, in one sentence that names the file, if it
  /// holds no background of this `model`.
  void loadBackground(const std::string& path);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// Opens, closes, fills holes up to `max_hole_px` and removes blobs under `min_blob_px`.
/// \param mask CV_8UC1, non-zero = person; returns 0 | 255
cv::Mat cleanMask(const cv::Mat& mask, const SilhouetteOptions& options);

}  // namespace markerless_mocap
