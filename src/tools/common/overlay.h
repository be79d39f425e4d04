#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// All views of a frame set in one image (CV_8UC3): the image, or else the mask, with the filled
/// body, the outlines of the mask and of its unknown pixels, the name of the camera, and the
/// overlap of body and mask. Each view is cropped to body and mask. \param masks one per camera;
/// may be empty mats \param bodies silhouettes of the body, one per camera, or none at all
cv::Mat overlayOf(const CameraRig& rig, const std::vector<CameraFrame>& frames,
                  const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& bodies);

}  // namespace markerless_mocap
