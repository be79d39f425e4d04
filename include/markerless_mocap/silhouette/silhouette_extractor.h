#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of one camera's silhouette stage.
struct SilhouetteOptions {
  static constexpr const char* kStage = "silhouette";
  int background_frames = 30;
  double threshold_sigmas = 3.0;
  double min_sigma = 4.0;
  bool compensate_flicker = true;
  bool remove_shadows = true;
  double shadow_darkest = 0.6;
  double shadow_chroma_tolerance = 0.025;
  int open_radius_px = 1;
  int close_radius_px = 2;
  int max_hole_px = 100;
  int min_blob_px = 200;

  void visit(OptionVisitor& v);
  /// Throws std::invalid_argument naming key, value and allowed range.
  void validate() const;
};

enum class SilhouetteState { kLearning, kReady };

/// Result of one frame.
struct SilhouetteResult {
  SilhouetteState state = SilhouetteState::kLearning;
  cv::Mat mask;  ///< CV_8UC1, 0 | 255, empty while learning
};

/// Background subtraction of one camera (ALGORITHM: per-pixel Gaussian learned from
/// background-only frames, shadow test, clean-up). Not thread-safe; one object per camera.
class SilhouetteExtractor {
 public:
  explicit SilhouetteExtractor(const SilhouetteOptions& options);
  /// \param image CV_8UC1 or CV_8UC3 (BGR), same size and type every time; throws
  ///   std::invalid_argument otherwise. The first `background_frames` images are learned from.
  SilhouetteResult update(const cv::Mat& image);
  /// Forgets the background; learning starts anew.
  void reset();
  int framesLearned() const { return frames_learned_; }

 private:
  void checkImage(const cv::Mat& image) const;
  void learn(const cv::Mat& image);
  void finishLearning();
  cv::Mat extract(const cv::Mat& image) const;

  SilhouetteOptions options_;
  int frames_learned_ = 0;
  cv::Size size_;
  int type_ = -1;                 ///< of the images; -1 before the first
  cv::Mat sum_, sum_of_squares_;  ///< CV_32FC(n) while learning
  cv::Mat mean_, inverse_sigma_;  ///< CV_32FC(n) when ready
};

/// Opens, closes, fills holes up to `max_hole_px` and removes blobs under `min_blob_px`.
/// \param mask CV_8UC1, non-zero = person; returns 0 | 255
cv::Mat cleanMask(const cv::Mat& mask, const SilhouetteOptions& options);

}  // namespace markerless_mocap
