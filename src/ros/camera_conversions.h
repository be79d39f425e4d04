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

/// A calibration for Camera from what a driver and tf say. Throws std::invalid_argument naming the
/// camera: size 0, all-zero or non-finite K, a distortion model other than plumb_bob or
/// rational_polynomial, a region of interest or binning (K would not fit the pixels), a transform
/// that is not finite or whose quaternion is not of length 1.
/// \param T_world_camera optical frame to world
CameraCalibration calibrationFromMessage(const std::string& name,
                                         const sensor_msgs::CameraInfo& info,
                                         const geometry_msgs::Transform& T_world_camera);

/// R is the identity, P = [K | 0]; the header is left to the caller.
sensor_msgs::CameraInfo messageFromCalibration(const CameraCalibration& calibration);

/// The frame of a camera that nobody named otherwise: <camera>_optical.
std::string opticalFrame(const std::string& camera);

/// world -> <camera>_optical of every camera.
tf2_msgs::TFMessage transformsOf(const std::vector<CameraCalibration>& cameras,
                                 const ros::Time& stamp, const std::string& world_frame);

}  // namespace markerless_mocap
