#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "contour/model/contour_body.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The masks of a person who is tracked, without what else they show. Parts that are beside the
/// predicted body, such as a bystander, become background. What is attached to the person and too
/// large for a limb, such as a box in front of their legs or an open door behind them, becomes
/// unknown up to the predicted body: its contours then say nothing, and colours tell the person
/// from it. A mask stays as it is where it does not show the predicted body, so that a wrong
/// prediction takes no person away.
/// \param masks by camera, CV_8UC1 0 | 128 unknown | 255, empty where missing; the same objects are
/// returned where nothing is changed
/// \param predicted world
std::vector<cv::Mat> withoutThingsBeside(const std::vector<cv::Mat>& masks, const CameraRig& rig,
                                         const ContourBody& body, const ContourPose& predicted);

}  // namespace markerless_mocap
