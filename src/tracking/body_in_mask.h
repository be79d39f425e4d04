#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Whether a silhouette may be of a body at that place: most joints lie in the silhouette and the
/// silhouette lies around the joints. True where the mask is unknown, and where neither joints nor
/// silhouette are in view. It tells a camera that is elsewhere than its calibration says, or has
/// another lens; not small errors.
/// \param mask CV_8UC1 of the camera's size: 0 | 128 unknown | 255
/// \param joints in world, m
bool mayShowBody(const Camera& camera, const cv::Mat& mask,
                 const std::vector<Eigen::Vector3d>& joints);

}  // namespace markerless_mocap
