#pragma once

#include <memory>
#include <opencv2/core/mat.hpp>
#include <string>

#include "markerless_mocap/silhouette/recording_learner.h"
#include "markerless_mocap/silhouette/silhouette_options.h"

namespace markerless_mocap {

/// kLearning: no mask yet. kReady: masks are valid. kStale: masks are still computed, but for some
/// time too much of the image has differed from the background (the camera was moved, furniture was
/// moved, the light was switched); the background should be learned again.
enum class SilhouetteState { kLearning, kReady, kStale };

/// Result of one frame.
struct SilhouetteResult {
  SilhouetteState state = SilhouetteState::kLearning;
  /// CV_8UC1: 0 background, 255 person, 128 unknown (the background there has not been seen yet).
  /// Empty while learning.
  cv::Mat mask;
  double unknown_fraction = 0;  ///< fraction of pixels that are unknown, 0 to 1
  /// Fraction of pixels that differ from the background, with shadows, 0 to 1; 0 for a network.
  double changed_fraction = 0;
  double light_gain = 1;  ///< brightness of the image divided by the background's
  /// Fraction of pixels that have become background with this image, 0 to 1: somebody or something
  /// stood there, still, while the background was learned, and has left.
  double uncovered_fraction = 0;
  /// Somebody has left the place where they kept still at first: the mask is that of the background
  /// with them in it, while another one is learned.
  bool is_learned_anew = false;
};

/// Background subtraction of one camera: a background model per pixel, a shadow test, clean-up. The
/// model `network` has no background and gives masks from the first image on.
/// Not thread-safe; one object per camera.
class SilhouetteExtractor {
 public:
  /// Throws std::invalid_argument as SilhouetteOptions::validate(), and with a message that names
  /// the file if the network cannot be loaded or gives an output of another shape than the options
  /// say.
  explicit SilhouetteExtractor(const SilhouetteOptions& options);
  ~SilhouetteExtractor();
  SilhouetteExtractor(SilhouetteExtractor&&) noexcept;
  SilhouetteExtractor& operator=(SilhouetteExtractor&&) noexcept;

  /// \param image CV_8UC1 or CV_8UC3 (BGR), same size and type in every call; throws
  ///   std::invalid_argument otherwise. The background is learned from the first
  ///   `background_frames` images. If somebody moves in them (option `background`), what these
  ///   images do not show is unknown, and is learned later, as people move.
  SilhouetteResult update(const cv::Mat& image);
  /// How many times smaller each side of an image of this size is made before all else (option
  /// `max_megapixels`); at least 1.
  int reductionFor(const cv::Size& image) const;
  /// The same for an image that may have been made that many times smaller already, as a decoder of
  /// JPEGs can. \param whole size of the image before that, and of the mask
  SilhouetteResult update(const cv::Mat& image, const cv::Size& whole);
  /// Takes over all settings from the next image on, but what SilhouetteOptions::fixedKeys() names:
  /// that stays, and so does the background. Throws std::invalid_argument as
  /// SilhouetteOptions::validate(); then nothing changes.
  void change(const SilhouetteOptions& options);
  /// Returns to the initial state: the background as it was loaded, or learning.
  void reset();
  /// From now on backgrounds are learned in another thread, of low priority, while images go on:
  /// for live images. Results, and how many images the first background takes, then depend on the
  /// time this takes.
  void learnBeside();
  /// Discards the background, also a loaded or given one, and starts learning.
  void relearn();
  int framesLearned() const;

  /// Throws std::invalid_argument with a message that names the file: while learning, if the file
  /// cannot be written, or if `model` is OpenCV's or a network, which cannot be saved.
  void saveBackground(const std::string& path) const;
  /// Loads a background instead of learning one. Throws std::invalid_argument with a message that
  /// names the file if it holds no background of this `model`.
  void loadBackground(const std::string& path);
  /// Uses a background instead of learning one; nullptr: learns. Throws std::invalid_argument if it
  /// is not of this `model`.
  void useBackground(const SharedBackground& background);
  /// A copy of the background in use; nullptr while learning, or if `model` has none to save.
  SharedBackground background() const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace markerless_mocap
