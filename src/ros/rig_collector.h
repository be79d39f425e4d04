#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Collects camera_info until the rig is known. A rig file replaces camera_info and tf.
class RigCollector {
 public:
  /// \param cameras names, in the order of the rig
  /// \param world_frame frame of the rig
  /// \param rig_file instead of camera_info and tf; empty: none. Throws as readRig() and
  ///   camerasNamed().
  RigCollector(std::vector<std::string> cameras, std::string world_frame,
               const std::string& rig_file = "");

  const std::vector<std::string>& cameras() const { return cameras_; }
  /// True if the rig comes from a file: no camera_info is needed.
  bool isFromFile() const { return file_.has_value(); }
  /// Message about cameras of the file that are not in `cameras`; empty if there are none.
  const std::string& unusedCameras() const { return unused_cameras_; }
  /// Time offset of each camera in the rig file, s; empty without a file or without offsets.
  std::vector<double> timeOffsets() const;
  /// Stores the message; returns true if it changes the rig.
  bool add(size_t camera, const sensor_msgs::CameraInfo& info);
  bool has(size_t camera) const { return infos_.at(camera).has_value(); }

  /// Message about what is missing: cameras without camera_info, or a frame that tf does not
  /// connect to the world. Empty if nothing is missing.
  std::string missing(const tf2::BufferCore& tf) const;

  /// Throws std::invalid_argument with the message of missing(), or as calibrationFromMessage().
  CameraRig rig(const tf2::BufferCore& tf) const;

 private:
  std::vector<std::string> cameras_;
  std::string world_frame_;
  std::vector<std::optional<sensor_msgs::CameraInfo>> infos_;
  std::optional<CameraRig> file_;  ///< the rig of the file, if there is one
  std::string unused_cameras_;
};

}  // namespace markerless_mocap
