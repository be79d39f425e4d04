#pragma once

#include <opencv2/core/mat.hpp>

#include "markerless_mocap/camera/camera.h"
#include "nodes/common/camera_image.h"

namespace markerless_mocap {

/// The mask in a message. Throws std::invalid_argument if it is none, or not of the camera's size.
cv::Mat maskOfCamera(const Camera& camera, const sensor_msgs::Image& message);
/// The same of a mask that was read from its message before.
cv::Mat maskOfCamera(const Camera& camera, const cv::Mat& mask);

/// The pixels of an image; empty if it cannot be read or is not of the camera's size.
cv::Mat imageOfCamera(const Camera& camera, const CameraImage& image);

}  // namespace markerless_mocap
