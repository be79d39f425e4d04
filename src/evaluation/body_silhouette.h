#pragma once

#include <Eigen/Geometry>
#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Silhouette of the body in a camera: the union of its round cones. Each cone is drawn as the
/// convex hull of the outlines of its two spheres, with the full lens model. A cone that is not
/// completely in front of the camera is left out. Outlines have 32 corners, so a limb of 50 px
/// width is drawn less than 0.3 px too thin.
/// \param T_world_link frames of all links, see BodyModel::forwardKinematics()
/// \param link_shown by link: whether its cones are drawn; empty: all
/// \return CV_8UC1 of the camera's size, 255 = body
cv::Mat bodySilhouette(const BodyModel& model, const LinkPoses& T_world_link, const Camera& camera,
                       const std::vector<bool>& link_shown = {});

/// Intersection over union of two masks of one size (CV_8UC1, non-zero = inside), 0 to 1; 0 if both
/// are empty. Pixels that are unknown (128) in one of them are left out. Throws
/// std::invalid_argument if sizes or types differ.
double maskIou(const cv::Mat& a, const cv::Mat& b);

}  // namespace markerless_mocap
