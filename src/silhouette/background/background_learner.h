#pragma once

#include <memory>
#include <vector>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// Collects images and learns a background from them: the most frequent colours of each pixel.
/// People may cross the scene if each pixel shows the scene more often than anything else.
class BackgroundLearner {
 public:
  /// \param frames number of images to learn from; if there are too many for the memory, an evenly
  ///   spaced selection is kept
  BackgroundLearner(int frames, bool compensate_flicker)
      : frames_(frames), compensate_flicker_(compensate_flicker) {}

  /// \param image CV_8UC1 or CV_8UC3, always the same size and type
  void add(const cv::Mat& image);
  int seen() const { return seen_; }
  bool isDone() const { return seen_ >= frames_; }
  /// \param modes number of modes per pixel, 1 to Background::kMaxModes
  Background learn(int modes, double min_sigma) const;

 private:
  void keep(const cv::Mat& image, size_t budget);

  int frames_;
  bool compensate_flicker_;
  int seen_ = 0;
  std::shared_ptr<uint8_t> pixels_;  ///< of all kept images
  std::vector<cv::Mat> kept_;
  std::vector<float> gains_;  ///< light of the kept images relative to the first
};

}  // namespace markerless_mocap
