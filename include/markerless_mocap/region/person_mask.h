#pragma once

#include <opencv2/core/mat.hpp>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// The person alone in one view. A silhouette shows all that differs from the background; this mask
/// lacks what is beside the fitted body, such as bystanders, boxes and patches of sun. Colours
/// decide where the silhouette is unknown or differs much from the body. What a silhouette lacks in
/// the middle of the body is filled in, but not in parts of which it shows less than half. Of limbs
/// that the pose says are not seen, such parts are as in the silhouette: a table may hide them.
/// Throws std::invalid_argument if the pose is lost, or the silhouette of another size or type.
/// \param pose fitted to this view
/// \param silhouette CV_8UC1 of the camera's size, 0 | 128 unknown | 255
/// \param image CV_8UC3 BGR of that size; any other is as good as none: what only colours could
///   decide stays unknown
/// \return CV_8UC1 of the camera's size, 0 | 128 unknown | 255
cv::Mat personMask(const Camera& camera, const BodyModel& model, const BodyPose& pose,
                   const cv::Mat& silhouette, const cv::Mat& image);

}  // namespace markerless_mocap
