#pragma once

#include <rosbag/bag.h>
#include <tf2/buffer_core.h>
#include <tf2_msgs/TFMessage.h>

namespace markerless_mocap {

/// Adds the transforms of /tf_static and /tf to the buffer. \param statics gets the static ones;
/// may be nullptr. Throws as messageOf().
void readTransforms(rosbag::Bag& bag, tf2::BufferCore* buffer, tf2_msgs::TFMessage* statics);

}  // namespace markerless_mocap
