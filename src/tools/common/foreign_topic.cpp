#include "tools/common/foreign_topic.h"

#include <rosbag/view.h>

namespace markerless_mocap {

std::string foreignTopic(const rosbag::Bag& bag, const std::vector<MessageType>& types) {
  rosbag::View view(bag);
  for (const rosbag::ConnectionInfo* topic : view.getConnections())
    for (const MessageType& type : types)
      if (topic->datatype == type.name && topic->md5sum != type.md5sum)
        return "; topic " + topic->topic + " holds a " + type.name +
               " of another md5 sum than this ROS has";
  return "";
}

}  // namespace markerless_mocap
