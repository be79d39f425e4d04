#pragma once

#include <cstdint>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Whether the bytes begin as a JPEG file does.
bool isJpeg(const std::vector<uint8_t>& bytes);

/// The image of a JPEG file, the same as cv::imdecode gives: CV_8UC1 or CV_8UC3 (BGR). Throws
/// std::invalid_argument if a part of it is missing or damaged; cv::imdecode would guess that part.
cv::Mat decodedJpeg(const std::vector<uint8_t>& bytes);

}  // namespace markerless_mocap
