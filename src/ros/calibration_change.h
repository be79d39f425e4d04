#pragma once

#include <geometry_msgs/Transform.h>
#include <sensor_msgs/CameraInfo.h>

#include <string>

namespace markerless_mocap {

/// Whether both are the same to the bit, so that one that is not finite is the same as itself.
/// Binning and region of interest are compared as well, the stamp is not.
bool sameCalibration(const sensor_msgs::CameraInfo& a, const sensor_msgs::CameraInfo& b);

/// Whether a camera has moved: by more than 1 mm, or a tenth of a pixel in most cameras.
bool isMoved(const geometry_msgs::Transform& from, const geometry_msgs::Transform& to);

/// For example "0.300 m and 0.0 degrees".
std::string distanceText(const geometry_msgs::Transform& from, const geometry_msgs::Transform& to);

}  // namespace markerless_mocap
