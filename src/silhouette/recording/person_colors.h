#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// Background of each pixel of the samples' size, as far as it is known.
struct SceneColors {
  cv::Mat color;  ///< CV_32FC3, grey levels
  cv::Mat known;  ///< CV_8UC1; non-zero: known
};

/// Colours of the people of a recording beside those of its background.
class PersonColors {
 public:
  PersonColors() = default;
  /// \param swept as sweptRegion()
  PersonColors(const SceneSamples& samples, const SceneColors& scene, const cv::Mat& swept);
  /// Logarithm of how much more frequent the colour is in people; 0 before anything is learned.
  float logRatio(const cv::Vec3f& color) const;

 private:
  std::vector<float> log_ratio_;
};

}  // namespace markerless_mocap
