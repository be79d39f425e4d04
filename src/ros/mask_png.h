#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// A mask as PNG, as image_transport's `compressed` sends mono8: grey of one bit per pixel where
/// every pixel is known, else of eight. \param mask CV_8UC1, 0 | 128 | 255
sensor_msgs::CompressedImage compressedMask(const cv::Mat& mask, const std_msgs::Header& header);

/// A mono8 image with the pixels of compressedMask(), or of any PNG with one channel of up to eight
/// bits. Throws std::invalid_argument if the message is no such PNG, is damaged, or says that it
/// has more pixels than its data can hold.
sensor_msgs::ImagePtr maskFromCompressed(const sensor_msgs::CompressedImage& message);

}  // namespace markerless_mocap
