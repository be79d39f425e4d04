#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Field of view of each camera as a pyramid of lines with the camera's name at the apex, in the
/// world frame.
visualization_msgs::MarkerArray cameraMarkers(const CameraRig& rig, const std_msgs::Header& header,
                                              double depth);

}  // namespace markerless_mocap
