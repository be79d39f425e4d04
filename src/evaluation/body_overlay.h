#pragma once

#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

#include "markerless_mocap/body/body_model.h"
#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Links that are drawn in one colour.
struct OverlayPart {
  std::vector<bool> link_shown;  ///< by link
  cv::Scalar color;              ///< BGR, 0 to 255
};

/// One camera's image with the body drawn into it, each part in its colour so that the image shows
/// through, with an outline; and with the outline of the mask in white.
/// \param image CV_8UC3 BGR or CV_8UC1 of the camera's size
/// \param mask CV_8UC1 of the camera's size, 0 | 128 unknown | 255; may be empty
/// \param T_world_link frames of all links, see BodyModel::forwardKinematics(); not used without
///   parts
/// \param parts empty: no body
/// \param text is written into the upper left corner
/// \return CV_8UC3. Throws std::invalid_argument if a size or type is another
cv::Mat bodyOverlay(const Camera& camera, const cv::Mat& image, const cv::Mat& mask,
                    const BodyModel& model, const LinkPoses& T_world_link,
                    const std::vector<OverlayPart>& parts, const std::string& text);

}  // namespace markerless_mocap
