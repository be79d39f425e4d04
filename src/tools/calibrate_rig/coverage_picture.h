#pragma once

#include <opencv2/core/mat.hpp>
#include <vector>

#include "calibration/board_coverage.h"

namespace markerless_mocap {

/// The images side by side, 480 pixels wide each, with the cells that were met in green, the
/// corners that are seen now, and how many places count. \param images by camera, CV_8UC1 or
/// CV_8UC3; may be empty \param corners by camera, seen now; may be empty
cv::Mat coveragePicture(const BoardCoverage& coverage, const std::vector<cv::Mat>& images,
                        const std::vector<BoardCorners>& corners);

}  // namespace markerless_mocap
