#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "markerless_mocap/pipeline/pipeline.h"

namespace markerless_mocap {

/// The box around mask and body with a margin, in the aspect ratio of the image; the whole image if
/// both are empty. \param mask, body CV_8UC1 of the image's size, or empty mats
cv::Rect partToShow(const cv::Size& image, const cv::Mat& mask, const cv::Mat& body);

/// All views of a frame set in one image (CV_8UC3): the image, or else the mask, with the filled
/// body, the outlines of the mask and of its unknown pixels, the name of the camera, and the
/// overlap of body and mask. Each view is cropped to body and mask. \param masks one per camera;
/// may be empty mats \param bodies silhouettes of the body, one per camera, or none at all
cv::Mat overlayOf(const CameraRig& rig, const std::vector<CameraFrame>& frames,
                  const std::vector<cv::Mat>& masks, const std::vector<cv::Mat>& bodies);

/// A picture with an area in the colour of what is unknown, so that the picture shows through.
/// \param picture CV_8UC3 \param area CV_8UC1 of its size, non-zero = tinted
cv::Mat unknownTinted(const cv::Mat& picture, const cv::Mat& area);

}  // namespace markerless_mocap
