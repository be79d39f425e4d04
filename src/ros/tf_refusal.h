#pragma once

#include <geometry_msgs/TransformStamped.h>

#include <string>

namespace markerless_mocap {

/// Why tf2 does not take a transform, which it only logs; empty if it does.
std::string tfRefusal(const geometry_msgs::TransformStamped& transform);

}  // namespace markerless_mocap
