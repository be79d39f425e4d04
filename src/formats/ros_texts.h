#pragma once

#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// The intrinsics as camera_info_manager reads them (YAML). Throws std::invalid_argument if the
/// lens has coefficients that no distortion model of ROS has.
std::string cameraInfoText(const CameraCalibration& camera);

/// A launch file that sends the static transforms world -> <camera>_optical.
std::string transformsLaunchText(const std::vector<CameraCalibration>& rig,
                                 const std::string& world_frame);

}  // namespace markerless_mocap
