#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "silhouette/recording/color_candidates.h"

namespace markerless_mocap {

/// Pixels that somebody may cover at some time of the recording: CV_8UC1, non-zero inside. Outside,
/// the most frequent colour is the background.
struct SweptRegion {
  cv::Mat seen;  ///< between differences that were seen
  cv::Mat all;   ///< and where parts may be that never move, of somebody who stays
};

SweptRegion sweptRegion(const SceneSamples& samples,
                        const std::vector<PixelCandidates>& candidates);

}  // namespace markerless_mocap
