#pragma once

#include <opencv2/core/mat.hpp>

#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/visual_hull.h"

namespace markerless_mocap {

/// The cells of an image that a voxel of the hull projects into, and their neighbours: CV_8UC1,
/// 0 | 255, one pixel per cell. \param cell edge of a cell, pixels
cv::Mat hullCells(const VisualHull& hull, const Camera& camera, int cell);

/// The cells of the hull in the size of the image.
cv::Mat hullPixels(const VisualHull& hull, const Camera& camera);

}  // namespace markerless_mocap
