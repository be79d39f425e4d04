#pragma once

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Settings of the edge detection; see FleischmannImageOptions.
struct EdgeSettings {
  double threshold = 30.0;
  int reach = 3;
  double blur = 2.0;
};

/// Proximity of each pixel to an edge of the person (Fleischmann 2012, 5.2.1): Sobel gradients
/// above a threshold within the dilated silhouette, blurred, and scaled to a maximum of 255. All 0
/// without edges.
/// \param image CV_8UC1 or CV_8UC3 (BGR)
/// \param silhouette CV_8UC1 of the same size, non-zero = person. Throws std::invalid_argument on
///   other types or sizes
/// \return CV_8UC1
cv::Mat edgeMap(const cv::Mat& image, const cv::Mat& silhouette, const EdgeSettings& settings);

}  // namespace markerless_mocap
