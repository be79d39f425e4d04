#pragma once

#include <opencv2/core/mat.hpp>

#include "markerless_mocap/silhouette/silhouette_extractor.h"

namespace markerless_mocap {

struct PixelTest {
  const SilhouetteOptions* options = nullptr;
  float inverse_gain = 1;  ///< takes the image to the light of the background model
};

/// What a test says about each pixel.
struct PixelClasses {
  cv::Mat mask;              ///< CV_8UC1, 0 | 255
  cv::Mat squared_distance;  ///< CV_32FC1, from the background, squared standard deviations
};

/// Foreground of a BGR or grey image: what is far from the background and no shadow. A shadow is
/// darker than its background, of the same colour, and of the same texture; in a grey image texture
/// alone tells.
PixelClasses classifyPixels(const PixelTest& test, const cv::Mat& image, const cv::Mat& mean,
                            const cv::Mat& inverse_sigma);

/// Removes pixels of the silhouette's rim that are nearer to the background than to the person
/// beside them: blur and chroma subsampling smear the outline over its neighbours.
void trimRim(const cv::Mat& squared_distance, cv::Mat* mask);

}  // namespace markerless_mocap
