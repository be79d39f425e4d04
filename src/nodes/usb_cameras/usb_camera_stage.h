#pragma once

#include <ros/node_handle.h>
#include <ros/wall_timer.h>
#include <tf2_ros/static_transform_broadcaster.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "markerless_mocap/camera/camera.h"
#include "nodes/common/callback_gate.h"
#include "nodes/common/stage_status.h"
#include "nodes/usb_cameras/camera_source.h"
#include "ros/node_options.h"

namespace markerless_mocap {

/// Publishes the images of USB cameras and, with a rig file, their camera_info and tf. Video files
/// start once the images of every camera are subscribed to, so that none of them is lost.
class UsbCameraStage {
 public:
  /// Throws std::runtime_error if a camera cannot be opened, and as readRig().
  UsbCameraStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                 const UsbCameraOptions& options);

 private:
  void readRigFile();
  bool isAwaited() const;
  void startWhenAwaited();
  void publish(size_t camera, int64_t stamp_ns, const cv::Mat& image);
  /// A sentence if images and calibration differ in size; else empty.
  std::string faultOf(size_t camera, const cv::Mat& image) const;

  UsbCameraOptions options_;
  StageStatus status_;
  std::vector<CameraCalibration> rig_;  ///< in the order of the cameras; empty without a rig file
  std::vector<ros::Publisher> images_, infos_;
  tf2_ros::StaticTransformBroadcaster broadcaster_;
  std::vector<std::unique_ptr<CameraSource>> sources_;  ///< their threads use the above
  ros::WallTimer timer_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
