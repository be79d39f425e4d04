#pragma once

#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <opencv2/core/mat.hpp>

namespace markerless_mocap {

/// An image that has come raw or compressed and is decoded when asked for; or none.
struct CameraImage {
  sensor_msgs::ImageConstPtr raw;
  sensor_msgs::CompressedImageConstPtr compressed;

  const std_msgs::Header& header() const { return raw ? raw->header : compressed->header; }
  /// Empty if there is no image. It must not outlive this. Throws std::invalid_argument as
  /// matFromMessage().
  cv::Mat mat() const;
};

}  // namespace markerless_mocap
