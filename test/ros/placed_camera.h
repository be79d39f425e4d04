#pragma once

#include <geometry_msgs/TransformStamped.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2/buffer_core.h>

#include <string>

#include "ros/camera_conversions.h"
#include "ros/sample_camera.h"

namespace markerless_mocap {

/// Of the sample camera.
inline sensor_msgs::CameraInfo infoIn(const std::string& frame) {
  sensor_msgs::CameraInfo info = messageFromCalibration(sampleCalibration());
  info.header.frame_id = frame;
  return info;
}

/// At the sample pose.
inline void place(tf2::BufferCore& tf, const std::string& frame) {
  geometry_msgs::TransformStamped transform;
  transform.header.frame_id = "world";
  transform.child_frame_id = frame;
  transform.transform = samplePose();
  tf.setTransform(transform, "test", true);
}

}  // namespace markerless_mocap
