#pragma once

#include "nodes/pose_fitting/camera_pictures.h"

namespace markerless_mocap {

/// The image with the body and the outline of the mask in it; empty without an image.
cv::Mat overlayOf(const FittedScene& scene, size_t camera, const cv::Mat& image);

/// The mask of the person alone; empty without a pose.
cv::Mat personMaskOf(const FittedScene& scene, size_t camera, const cv::Mat& image);

}  // namespace markerless_mocap
