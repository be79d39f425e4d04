#pragma once

#include <opencv2/core/mat.hpp>
#include <string>

namespace markerless_mocap {

/// Escapes text for use between tags and in attributes.
std::string escapeHtml(const std::string& text);

/// A figure with its caption; the image (CV_8UC3) is embedded as JPEG.
std::string pictureTag(const cv::Mat& image, const std::string& caption);

/// A self-contained page in the style of the reports. \param body HTML
std::string htmlPage(const std::string& title, const std::string& body);

}  // namespace markerless_mocap
