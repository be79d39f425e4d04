#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// Whether something as large as a person moves in the images.
bool showMotion(const SceneSamples& samples);

/// Whether something stood in the first images that later is gone: a region which is constant
/// later on, as is what surrounds it, but differs from the first images. Somebody who comes later
/// and stays in one place leaves such a region, too, but moves around it.
/// \param later CV_8UC3 of the samples' size
bool showWhatLeftLater(const SceneSamples& first, const std::vector<cv::Mat>& later);

}  // namespace markerless_mocap
