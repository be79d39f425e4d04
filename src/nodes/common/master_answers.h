#pragma once

#include <ros/master.h>

namespace markerless_mocap {

/// Whether roscore answers. To be asked before a topic is subscribed, or looked for, while poses
/// are wanted: both wait for a roscore that is away until it is back.
inline bool masterAnswers() {
  return ros::master::check();
}

}  // namespace markerless_mocap
