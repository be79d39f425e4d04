#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace markerless_mocap {

/// Text that can stand between tags and in attributes.
std::string escapeHtml(const std::string& text);

/// A figure with its caption, the picture (CV_8UC3) as JPEG within.
std::string pictureTag(const cv::Mat& image, const std::string& caption);

/// A whole page that needs nothing beside it, in the reports' style. \param body HTML
std::string htmlPage(const std::string& title, const std::string& body);

}  // namespace markerless_mocap
