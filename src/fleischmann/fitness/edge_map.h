#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// How edges are found; see FleischmannImageOptions.
struct EdgeSettings {
  double threshold = 30.0;
  int reach = 3;
  double blur = 2.0;
};

/// How near each pixel is to an edge of the person, after Fleischmann 2012, 5.2.1: Sobel gradients
/// above a threshold, within the dilated silhouette, blurred and stretched so that the highest
/// value is 255. All 0 where there are none.
/// \param image CV_8UC1 or CV_8UC3 (BGR) \param silhouette CV_8UC1 of the same size, non-zero =
///   person; throws std::invalid_argument on other types or sizes
/// \return CV_8UC1
cv::Mat edgeMap(const cv::Mat& image, const cv::Mat& silhouette, const EdgeSettings& settings);

}  // namespace markerless_mocap
