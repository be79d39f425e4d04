#pragma once

#include <geometry_msgs/Transform.h>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// A camera turned a quarter about z, at (1, 2, 3).
inline geometry_msgs::Transform samplePose() {
  geometry_msgs::Transform pose;
  pose.translation.x = 1.0;
  pose.translation.y = 2.0;
  pose.translation.z = 3.0;
  pose.rotation.z = pose.rotation.w = std::sqrt(0.5);
  return pose;
}

inline CameraCalibration sampleCalibration() {
  CameraCalibration calibration;
  calibration.name = "cam3";
  calibration.width = 640;
  calibration.height = 480;
  calibration.K << 500.0, 0.0, 319.5, 0.0, 510.0, 239.5, 0.0, 0.0, 1.0;
  calibration.D = {-0.1, 0.02, 0.001, -0.002, 0.003};
  calibration.T_world_camera.linear() << 0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
  calibration.T_world_camera.translation() << 1.0, 2.0, 3.0;
  return calibration;
}

}  // namespace markerless_mocap
