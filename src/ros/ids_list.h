#pragma once

#include <ros/message_traits.h>
#include <ros/serialization.h>
#include <std_msgs/Header.h>

#include <string>
#include <vector>

namespace markerless_mocap {

/// hri_msgs/IdsList 0.9.0 of REP-155, the same on the wire. Debian has no hri_msgs; clients that
/// were built with it, such as libhri and hri_rviz, receive this.
struct IdsList {
  std_msgs::Header header;
  std::vector<std::string> ids;
};

/// Topic of the bodies that are tracked, latched.
constexpr const char* kTrackedBodies = "/humans/bodies/tracked";

}  // namespace markerless_mocap

namespace ros {
namespace message_traits {

template <>
struct DataType<markerless_mocap::IdsList> {
  static const char* value() { return "hri_msgs/IdsList"; }
  static const char* value(const markerless_mocap::IdsList&) { return value(); }
};

template <>
struct MD5Sum<markerless_mocap::IdsList> {
  static const char* value() { return "84a63f55b5676f78b625e8a8bb809fe5"; }
  static const char* value(const markerless_mocap::IdsList&) { return value(); }
};

template <>
struct Definition<markerless_mocap::IdsList> {
  static const char* value() {
    return "Header header\n"
           "string[] ids\n"
           "================================================================================\n"
           "MSG: std_msgs/Header\n"
           "uint32 seq\n"
           "time stamp\n"
           "string frame_id\n";
  }
  static const char* value(const markerless_mocap::IdsList&) { return value(); }
};

template <>
struct HasHeader<markerless_mocap::IdsList> : TrueType {};

}  // namespace message_traits

namespace serialization {

template <>
struct Serializer<markerless_mocap::IdsList> {
  template <typename Stream, typename T>
  static void allInOne(Stream& stream, T message) {
    stream.next(message.header);
    stream.next(message.ids);
  }
  ROS_DECLARE_ALLINONE_SERIALIZER
};

}  // namespace serialization
}  // namespace ros
