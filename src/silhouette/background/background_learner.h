#pragma once

#include <vector>

#include "silhouette/background/background.h"

namespace markerless_mocap {

/// Gathers images and makes a background of them: of each pixel the most usual colours, so people
/// may cross the scene as long as every pixel shows the scene more often than anything else.
class BackgroundLearner {
 public:
  /// \param frames images to look at; of more than memory allows, an even choice is kept
  BackgroundLearner(int frames, bool compensate_flicker)
      : frames_(frames), compensate_flicker_(compensate_flicker) {}

  /// \param image CV_8UC1 or CV_8UC3, all alike
  void add(const cv::Mat& image);
  int seen() const { return seen_; }
  bool isDone() const { return seen_ >= frames_; }
  /// \param modes usual colours per pixel, 1 to Background::kMostModes
  Background learn(int modes, double min_sigma) const;

 private:
  int frames_;
  bool compensate_flicker_;
  int seen_ = 0;
  std::vector<cv::Mat> kept_;
  std::vector<float> gains_;  ///< light of the kept images relative to the first
};

}  // namespace markerless_mocap
