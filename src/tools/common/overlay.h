#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// All views of an instant in one picture (CV_8UC3): the image, or the mask where there is none,
/// with the body filled and the mask's outline, the camera's name and the overlap of the two. Each
/// view shows the part of the image that body and mask cover.
/// \param masks one per camera, may be empty mats \param bodies silhouettes of the body, one per
///   camera, or none at all
cv::Mat overlayOf(const CameraRig& rig, const std::vector<CameraFrame>& frames,
                  const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& bodies);

}  // namespace markerless_mocap
