#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <sensor_msgs/Image.h>

namespace markerless_mocap {

/// A sensor_msgs/Image read into the memory of an earlier one that nobody holds any more: new
/// memory is set to zero and its pages are got from the system, which takes as long as reading.
/// Pixels must not outlive `image`.
struct ReusedImage {
  sensor_msgs::Image::Ptr image;
};

/// An image that is free; it holds what was in it. Thread safe.
sensor_msgs::Image::Ptr takeFreeImage();

}  // namespace markerless_mocap

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<markerless_mocap::ReusedImage> : MD5Sum<sensor_msgs::Image> {};
template <>
struct DataType<markerless_mocap::ReusedImage> : DataType<sensor_msgs::Image> {};
template <>
struct Definition<markerless_mocap::ReusedImage> : Definition<sensor_msgs::Image> {};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<markerless_mocap::ReusedImage> {
  template <typename Stream>
  static void read(Stream& stream, markerless_mocap::ReusedImage& message) {
    message.image = markerless_mocap::takeFreeImage();
    deserialize(stream, *message.image);
  }
};

}  // namespace serialization
}  // namespace ros
