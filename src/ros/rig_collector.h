#pragma once

#include <sensor_msgs/CameraInfo.h>
#include <tf2/buffer_core.h>

#include <optional>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"

namespace markerless_mocap {

/// Gathers what the cameras say about themselves until the rig is known, or takes it from a file,
/// which then stands for all that they say.
class RigCollector {
 public:
  /// \param cameras names, in the order of the rig
  /// \param world_frame frame that the rig is given in
  /// \param rig_file in place of camera_info and tf; empty: none
  /// Throws as readRig() and camerasNamed() do.
  RigCollector(std::vector<std::string> cameras, std::string world_frame,
               const std::string& rig_file = "");

  const std::vector<std::string>& cameras() const { return cameras_; }
  /// Whether the rig comes from a file: nobody needs to listen to camera_info.
  bool isFromFile() const { return file_.has_value(); }
  /// One sentence on cameras of the file that are not among those wanted; empty: there are none.
  const std::string& remark() const { return remark_; }
  /// Keeps the message; returns whether it says anything new about the rig.
  bool add(size_t camera, const sensor_msgs::CameraInfo& info);
  bool has(size_t camera) const { return infos_.at(camera).has_value(); }

  /// One sentence: cameras without camera_info, or a frame that tf does not connect to the world.
  /// Empty when nothing is missing.
  std::string missing(const tf2::BufferCore& tf) const;

  /// Throws std::invalid_argument with the sentence of missing(), or as calibrationFromMessage().
  CameraRig rig(const tf2::BufferCore& tf) const;

 private:
  std::vector<std::string> cameras_;
  std::string world_frame_;
  std::vector<std::optional<sensor_msgs::CameraInfo>> infos_;
  std::optional<CameraRig> file_;  ///< the rig if it is a file's
  std::string remark_;
};

}  // namespace markerless_mocap
