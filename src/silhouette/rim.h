#pragma once

#include <opencv2/core/mat.hpp>

#include "silhouette/background.h"
#include "silhouette/pixel_test.h"

namespace markerless_mocap {

/// Sets the silhouette's rim to where an image is half person, half background: blur and chroma
/// subsampling smear the outline over its neighbours. What the person looks like is taken from just
/// inside, the background from its model and the shadow just outside.
void refineRim(const cv::Mat& image, const Background& background, double gain,
               const PixelClasses& classes, BitMask* mask);

}  // namespace markerless_mocap
