#pragma once

#include <opencv2/core/mat.hpp>

#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {

struct PixelTest {
  const SilhouetteOptions* options = nullptr;
  float inverse_gain = 1;  ///< takes the image to the light of the background model
};

/// Foreground of a BGR image (0 | 255): what is far from the background and no shadow. A shadow is
/// darker than its background and of the same colour.
cv::Mat classifyColor(const PixelTest& test, const cv::Mat& image, const cv::Mat& mean,
                      const cv::Mat& inverse_sigma);

/// As classifyColor() for a grey image. Without colour, a shadow is told by its texture: the
/// brightness relative to the background is the same all around.
cv::Mat classifyGrey(const PixelTest& test, const cv::Mat& image, const cv::Mat& mean,
                     const cv::Mat& inverse_sigma);

}  // namespace markerless_mocap
