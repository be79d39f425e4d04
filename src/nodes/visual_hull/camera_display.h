#pragma once

#include <ros/node_handle.h>

#include <mutex>
#include <optional>
#include <vector>

#include "markerless_mocap/ros/messages.h"
#include "nodes/common/callback_gate.h"
#include "ros/camera_markers.h"

namespace markerless_mocap {

/// The cameras and their health as markers on hull/cameras, latched; published when something has
/// changed, at most twice a second. Thread-safe.
class CameraDisplay {
 public:
  CameraDisplay(ros::NodeHandle& handle, size_t cameras);

  void setRig(const CameraRig& rig, const std_msgs::Header& header);
  /// Takes the health of the cameras from a frame set.
  /// \param present by camera: whether it has a mask
  void note(const HullCameras& frame_set, const std::vector<bool>& present);

 private:
  void update();

  std::mutex mutex_;
  std::optional<CameraRig> rig_;
  std_msgs::Header header_;
  std::vector<CameraHealth> health_;
  bool changed_ = false;
  double last_note_ = 0.0;  ///< s
  ros::Publisher publisher_;
  ros::WallTimer timer_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
