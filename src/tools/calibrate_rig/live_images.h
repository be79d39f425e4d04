#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>

#include <deque>
#include <opencv2/core/mat.hpp>
#include <string>
#include <vector>

namespace markerless_mocap {

/// An image that may not be needed, and so is not decoded. Neither raw nor compressed: none.
struct Arrival {
  double time = 0.0;  ///< s
  sensor_msgs::Image::ConstPtr raw;
  sensor_msgs::CompressedImage::ConstPtr compressed;
};

struct Decoded {
  cv::Mat image;        ///< empty if there is none
  std::string problem;  ///< why it cannot be used
};
Decoded decoded(const Arrival& arrival);

/// Newest images of all cameras, from <camera>/image_raw or image_raw/compressed.
class LiveImages {
 public:
  LiveImages(ros::NodeHandle& node, const std::vector<std::string>& cameras);

  Arrival newest(size_t camera) const;
  /// The newest time that all cameras have reached, but for those that are silent, s; infinite if
  /// there are no images.
  double commonTime() const;
  /// The image nearest to a time; empty if there is none nearer than `within`, s.
  Arrival nearest(size_t camera, double time, double within) const;

 private:
  void add(size_t camera, Arrival arrival);

  std::vector<std::deque<Arrival>> buffers_;
  std::vector<ros::Subscriber> subscribers_;
};

}  // namespace markerless_mocap
