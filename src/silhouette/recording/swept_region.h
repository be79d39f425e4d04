#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/recording/color_candidates.h"

namespace markerless_mocap {

/// Pixels that somebody may cover at some time of the recording: CV_8UC1, non-zero inside. Outside,
/// the most frequent colour is the background.
cv::Mat sweptRegion(const SceneSamples& samples, const std::vector<PixelCandidates>& candidates);

}  // namespace markerless_mocap
