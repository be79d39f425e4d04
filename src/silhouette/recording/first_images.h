#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/recording/scene_samples.h"

namespace markerless_mocap {

/// Whether something as large as a person moves. \param moving see SceneSamples
bool showMotion(const std::vector<cv::Mat>& moving);

/// Whether something stood still in the first images that later is gone: a region with an outline
/// in the first images, of another constant colour later, and constant around it, too.
/// \param later CV_8UC3 of the samples' size
bool showWhatLeftLater(const SceneSamples& first, const std::vector<cv::Mat>& later);

}  // namespace markerless_mocap
