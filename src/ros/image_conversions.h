#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// Pixels of an image message: CV_8UC1 from a grey encoding, CV_8UC3 (BGR) from any colour one
/// (mono8, mono16, bgr8, rgb8, bgra8, rgba8, the four Bayer patterns of 8 bits). Throws
/// std::invalid_argument on another encoding or too little data. The result owns its pixels.
cv::Mat matFromMessage(const sensor_msgs::Image& message);

/// The same without a copy where pixels need no conversion: the result must not outlive the
/// message.
cv::Mat sharedMatFromMessage(const sensor_msgs::Image& message);

/// As matFromMessage() from JPEG, PNG or whatever else OpenCV decodes. Throws std::invalid_argument
/// if it cannot be decoded.
cv::Mat matFromMessage(const sensor_msgs::CompressedImage& message);

/// A mask (CV_8UC1, 0 | 255) from a message; every non-zero pixel becomes 255. Throws
/// std::invalid_argument unless the encoding is mono8.
cv::Mat maskFromMessage(const sensor_msgs::Image& message);

/// \param image CV_8UC1 becomes mono8, CV_8UC3 (BGR) becomes bgr8; throws std::invalid_argument on
///   another type
sensor_msgs::Image messageFromMat(const cv::Mat& image, const std_msgs::Header& header);

}  // namespace markerless_mocap
