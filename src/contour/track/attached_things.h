#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The masks of a person who is tracked, without large things that are attached to their outline,
/// such as a box in front of their legs or an open door behind them: what is far from the predicted
/// body becomes unknown, so that its contours say nothing and colours tell the person from it. Only
/// where the mask also shows the predicted body and some of its outline, and only if there is too
/// much of it for a limb.
/// \param masks by camera, CV_8UC1 0 | 128 unknown | 255, empty where missing; the same objects are
/// returned where nothing is marked
/// \param predicted world
std::vector<cv::Mat> withoutAttachedThings(const std::vector<cv::Mat>& masks, const CameraRig& rig,
                                           const ContourBody& body, const ContourPose& predicted);

}  // namespace markerless_mocap
