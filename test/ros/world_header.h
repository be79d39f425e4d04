#pragma once

#include <std_msgs/Header.h>

namespace markerless_mocap {

inline std_msgs::Header worldHeader() {
  std_msgs::Header header;
  header.frame_id = "world";
  header.stamp = ros::Time(1000, 7);
  return header;
}

}  // namespace markerless_mocap
