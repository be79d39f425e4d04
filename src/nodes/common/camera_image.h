#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

#include "ros/jpeg_image.h"

namespace markerless_mocap {

/// A raw or compressed image, decoded on demand.
struct CameraImage {
  sensor_msgs::ImageConstPtr raw;
  sensor_msgs::CompressedImageConstPtr compressed;
  ros::Time received{};  ///< when it was put in the queue of its subscriber

  explicit operator bool() const { return raw || compressed; }
  const std_msgs::Header& header() const { return raw ? raw->header : compressed->header; }
  /// The decoded image, empty if there is none. This object must outlive it. Throws
  /// std::invalid_argument as
  /// matFromMessage().
  cv::Mat mat() const;
  /// The same; a JPEG may come smaller, see decodedJpeg(). \param whole the size before that
  cv::Mat mat(const ReductionRule& rule, cv::Size* whole) const;
};

}  // namespace markerless_mocap
