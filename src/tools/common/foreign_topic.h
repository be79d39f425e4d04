#pragma once

#include <ros/message_traits.h>
#include <rosbag/bag.h>

#include <string>
#include <vector>

namespace markerless_mocap {

struct MessageType {
  std::string name, md5sum;
};

/// Says which topic holds a message of one of these types, but of another md5 sum than this ROS
/// has, so that messageOf() is null; begins with "; ". Empty if there is none.
std::string foreignTopic(const rosbag::Bag& bag, const std::vector<MessageType>& types);

template <class... Messages>
std::string foreignTopic(const rosbag::Bag& bag) {
  return foreignTopic(bag, {{ros::message_traits::datatype<Messages>(),
                             ros::message_traits::md5sum<Messages>()}...});
}

}  // namespace markerless_mocap
