#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/silhouette/silhouette_options.h"

namespace markerless_mocap {

class Background;
/// Whether the options allow to learn from a recording: `model` is gaussian and `background` is not
/// `first_images`.
bool canLearnFromRecording(const SilhouetteOptions& options);

/// The learned background of one camera, for SilhouetteExtractor::useBackground().
using SharedBackground = std::shared_ptr<const Background>;
/// Fraction of pixels whose background is not known, 0 to 1.
double unknownFraction(const Background& background);

/// Learns the background of one camera from a whole recording, in a pass before the one that makes
/// the masks. Nobody need leave the scene: a pixel's background is what it shows while nobody
/// covers it, as far as that continues the background around it. Where that is never seen, the
/// background is unknown. Not thread-safe; one object per camera.
class RecordingLearner {
 public:
  /// \param expected_images about as many as the recording has
  /// Throws std::invalid_argument as SilhouetteOptions::validate(), or if
  ///   !canLearnFromRecording(options).
  RecordingLearner(const SilhouetteOptions& options, int expected_images);
  ~RecordingLearner();
  RecordingLearner(RecordingLearner&&) noexcept;
  RecordingLearner& operator=(RecordingLearner&&) noexcept;

  /// Whether the next image is needed; if not, an empty one may be added in its place.
  bool wantsNext() const;
  /// \param image CV_8UC1 or CV_8UC3 (BGR), in the order of time; empty if it is missing. Throws
  ///   std::invalid_argument if its type is another, or if size or type change.
  void add(const cv::Mat& image);
  /// Whether somebody is in the first `background_frames` images: something moves in them, has the
  /// shape of a person, or was there and is gone later. Motion shows in four images or more. True
  /// if option `background` is `recording`.
  bool isOccupiedAtFirst() const;
  /// Throws std::invalid_argument if no image was added.
  SharedBackground learn() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

/// The backgrounds of a recording's cameras. With option `background: auto`, nullptr for all if
/// fewer than half of the cameras have somebody in the first images, as then these images give the
/// background, and nullptr for those cameras that have nobody.
std::vector<SharedBackground> learnBackgrounds(const std::vector<RecordingLearner>& learners);

}  // namespace markerless_mocap
