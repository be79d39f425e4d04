#pragma once

#include <visualization_msgs/MarkerArray.h>

#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// How it stands with a camera. kSilent: nothing has come for some time; kDoubtful: it is used, but
/// something is wrong; kLeftOut: it is not used.
struct CameraHealth {
  enum State { kSilent, kUsed, kDoubtful, kLeftOut };
  State state = kSilent;
  std::string reason;  ///< empty where nothing is wrong

  bool operator!=(const CameraHealth& other) const {
    return state != other.state || reason != other.reason;
  }
};

/// Field of view of each camera as a pyramid of lines with the camera's name at the apex, in the
/// world frame. Green: used; yellow: doubtful; red: left out; grey: silent. The reason is below the
/// name. \param health one per camera
visualization_msgs::MarkerArray cameraMarkers(const CameraRig& rig,
                                              const std::vector<CameraHealth>& health,
                                              const std_msgs::Header& header, double depth);

}  // namespace markerless_mocap
