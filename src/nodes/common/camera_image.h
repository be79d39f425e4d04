#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <functional>
#include <opencv2/core/mat.hpp>
#include <string>

namespace markerless_mocap {

/// An image that has come raw or compressed and is decoded when asked for.
struct CameraImage {
  sensor_msgs::ImageConstPtr raw;
  sensor_msgs::CompressedImageConstPtr compressed;

  const std_msgs::Header& header() const { return raw ? raw->header : compressed->header; }
  /// It must not outlive this. Throws std::invalid_argument as matFromMessage().
  cv::Mat mat() const;
};

std::string imageTopic(const std::string& camera, const std::string& transport);

/// \param transport raw or compressed
ros::Subscriber subscribeImages(ros::NodeHandle& handle, const std::string& camera,
                                const std::string& transport, uint32_t queue,
                                std::function<void(const CameraImage&)> callback);

/// One sentence for a topic on which nothing comes: its name and the graph's topics of that type.
std::string silentTopic(const std::string& topic, const std::string& type);

}  // namespace markerless_mocap
