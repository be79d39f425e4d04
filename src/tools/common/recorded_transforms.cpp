#include "tools/common/recorded_transforms.h"

#include <string>

#include "tools/common/bag_io.h"

namespace markerless_mocap {

void readTransforms(rosbag::Bag& bag, tf2::BufferCore* buffer, tf2_msgs::TFMessage* statics) {
  for (const char* topic : {"/tf_static", "/tf"}) {
    const bool is_static = std::string(topic) == "/tf_static";
    for (const rosbag::MessageInstance& entry : rosbag::View(bag, rosbag::TopicQuery(topic))) {
      const auto message = messageOf<tf2_msgs::TFMessage>(entry);
      if (!message) continue;
      for (const geometry_msgs::TransformStamped& transform : message->transforms) {
        buffer->setTransform(transform, "bag", is_static);
        if (is_static && statics) statics->transforms.push_back(transform);
      }
    }
  }
}

}  // namespace markerless_mocap
