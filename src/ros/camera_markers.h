#pragma once

#include <visualization_msgs/MarkerArray.h>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Each camera's field of view as a line pyramid with its name at the apex, in the world frame.
/// \param depth length of the pyramid along the optical axis, metres
visualization_msgs::MarkerArray cameraMarkers(const CameraRig& rig, const std_msgs::Header& header,
                                              double depth);

}  // namespace markerless_mocap
