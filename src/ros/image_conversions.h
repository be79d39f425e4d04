#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

#include "ros/jpeg_image.h"

namespace markerless_mocap {

/// Pixels of an image message: CV_8UC1 from a grey encoding, CV_8UC3 (BGR) from a colour encoding
/// (mono8, mono16, bgr8, rgb8, bgra8, rgba8, the four 8-bit Bayer patterns). The result owns its
/// pixels. Throws std::invalid_argument on another encoding or too little data.
cv::Mat matFromMessage(const sensor_msgs::Image& message);

/// As matFromMessage(), but without a copy if the pixels need no conversion: the message must
/// outlive the result.
cv::Mat sharedMatFromMessage(const sensor_msgs::Image& message);

/// As matFromMessage() from JPEG, PNG or another format that OpenCV decodes. Throws
/// std::invalid_argument if the image cannot be decoded, or a part of a JPEG is missing or damaged.
cv::Mat matFromMessage(const sensor_msgs::CompressedImage& message);
/// The same; a JPEG may come smaller, see decodedJpeg(). \param whole the size before that
cv::Mat matFromMessage(const sensor_msgs::CompressedImage& message, const ReductionRule& rule,
                       cv::Size* whole);

/// A mask (CV_8UC1, 0 | 128 unknown | 255) from a message; pixels of other values become 255.
/// Throws std::invalid_argument unless the encoding is mono8.
cv::Mat maskFromMessage(const sensor_msgs::Image& message);

/// As hasUnknownBackground() of the mask in a message; false if the message is no mask.
bool hasUnknownBackground(const sensor_msgs::Image& message);

/// \param image CV_8UC1 becomes mono8, CV_8UC3 (BGR) becomes bgr8; throws std::invalid_argument on
///   another type
sensor_msgs::Image messageFromMat(const cv::Mat& image, const std_msgs::Header& header);

}  // namespace markerless_mocap
