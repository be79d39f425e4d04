#pragma once

#include <geometry_msgs/Transform.h>
#include <ros/time.h>
#include <sensor_msgs/CameraInfo.h>
#include <tf2_msgs/TFMessage.h>

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Nanoseconds since the epoch.
int64_t nanosecondsOf(const ros::Time& stamp);
ros::Time rosTime(int64_t nanoseconds);

/// \param distortion_model as in camera_info
LensType lensTypeOf(const std::string& distortion_model);

/// Calibration of a camera from camera_info and tf. Throws std::invalid_argument, naming the
/// camera, if the size is 0, if K is all zero or not finite, if the distortion model is not
/// plumb_bob, rational_polynomial or equidistant, if there is a region of interest or binning (K
/// would not fit the pixels), or if the transform is not finite or its quaternion has not length 1.
CameraCalibration calibrationFromMessage(const std::string& name,
                                         const sensor_msgs::CameraInfo& info,
                                         const geometry_msgs::Transform& T_world_camera);

/// R is the identity, P = [K | 0]; the caller fills in the header.
sensor_msgs::CameraInfo messageFromCalibration(const CameraCalibration& calibration);

/// Default frame of a camera: <camera>_optical.
std::string opticalFrame(const std::string& camera);

/// world -> <camera>_optical of every camera.
tf2_msgs::TFMessage transformsOf(const std::vector<CameraCalibration>& cameras,
                                 const ros::Time& stamp, const std::string& world_frame);

}  // namespace markerless_mocap
