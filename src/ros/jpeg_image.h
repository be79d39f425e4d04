#pragma once

#include <cstdint>
#include <functional>
#include <opencv2/core/mat.hpp>
#include <vector>

namespace markerless_mocap {

/// Whether the bytes begin as a JPEG file does.
bool isJpeg(const std::vector<uint8_t>& bytes);

/// The image of a JPEG file, the same as cv::imdecode gives: CV_8UC1 or CV_8UC3 (BGR). Throws
/// std::invalid_argument if a part of it is missing or damaged; cv::imdecode would guess that part.
cv::Mat decodedJpeg(const std::vector<uint8_t>& bytes);

/// Decides by an image's size how many times smaller it is wanted.
using ReductionRule = std::function<int(const cv::Size&)>;

/// The same, 2, 4 or 8 times smaller if the rule says so: then only a part of the work is done.
/// Sides are rounded up. \param whole the size of the image in the file
cv::Mat decodedJpeg(const std::vector<uint8_t>& bytes, const ReductionRule& rule, cv::Size* whole);

}  // namespace markerless_mocap
