#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/background/background.h"
#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// Mean and deviation of those samples of each pixel that show the background.
class RowStatistics {
 public:
  /// \param samples must outlive this
  explicit RowStatistics(const SceneSamples& samples);

  /// Fills one row of a background of one mode.
  /// \param expected rough colours of the row, grey levels
  void measure(int y, const cv::Vec3f* expected, Background& background);

 private:
  const SceneSamples& samples_;
  int width_, channels_;
  std::vector<float> expected_, sums_;            ///< one plane for each channel
  std::vector<float> squares_, counts_, shifts_;  ///< of each pixel
};

}  // namespace markerless_mocap
