#include "nodes/common/camera_image.h"

#include <ros/master.h>

#include "nodes/common/low_latency_transport.h"
#include "ros/image_conversions.h"

namespace markerless_mocap {

cv::Mat CameraImage::mat() const {
  return raw ? sharedMatFromMessage(*raw) : matFromMessage(*compressed);
}

std::string imageTopic(const std::string& camera, const std::string& transport) {
  return camera + (transport == "compressed" ? "/image_raw/compressed" : "/image_raw");
}

ros::Subscriber subscribeImages(ros::NodeHandle& handle, const std::string& camera,
                                const std::string& transport, uint32_t queue,
                                std::function<void(const CameraImage&)> callback) {
  const std::string topic = imageTopic(camera, transport);
  if (transport == "compressed")
    return handle.subscribe<sensor_msgs::CompressedImage>(
        topic, queue,
        [callback](const sensor_msgs::CompressedImageConstPtr& message) {
          callback({nullptr, message});
        },
        {}, lowLatencyTransport());
  return handle.subscribe<sensor_msgs::Image>(
      topic, queue,
      [callback](const sensor_msgs::ImageConstPtr& message) {
        callback({message, nullptr});
      },
      {}, lowLatencyTransport());
}

std::string silentTopic(const std::string& topic, const std::string& type) {
  ros::master::V_TopicInfo topics;
  ros::master::getTopics(topics);
  std::string others;
  for (const ros::master::TopicInfo& info : topics)
    if (info.datatype == type && info.name != topic)
      others += (others.empty() ? "" : ", ") + info.name;
  return "nothing comes on " + topic + " (" + type + "); topics of that type are " +
         (others.empty() ? "none" : others);
}

}  // namespace markerless_mocap
