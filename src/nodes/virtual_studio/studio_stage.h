#pragma once

#include <ros/node_handle.h>
#include <tf2_ros/static_transform_broadcaster.h>
#include <tf2_ros/transform_broadcaster.h>

#include <vector>

#include "capture/virtual_studio.h"
#include "nodes/common/callback_gate.h"
#include "nodes/common/stage_status.h"
#include "ros/node_options.h"

namespace markerless_mocap {

/// Publishes the frame sets of the virtual studio and their ground truth, one per tick. If the
/// machine is too slow for the frame rate, time in the studio passes more slowly.
class StudioStage {
 public:
  StudioStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
              const StudioOptions& options, const StudioNodeOptions& node_options);

 private:
  void advertise(ros::NodeHandle& handle);
  void publishRig();
  bool isAwaited() const;
  void tick();
  void publish(const StudioFrameSet& frame_set, const ros::Time& stamp);
  void publishCamera(size_t camera, const StudioFrameSet& frame_set,
                     const std_msgs::Header& header);
  void publishTruth(const StudioFrameSet& frame_set, const std_msgs::Header& header);

  ros::NodeHandle handle_;
  StudioNodeOptions node_options_;
  VirtualStudio studio_;
  StageStatus status_;
  int next_ = 0;
  std::vector<ros::Publisher> images_, infos_, masks_;  ///< by camera
  ros::Publisher clock_, joints_, joint_states_;
  tf2_ros::StaticTransformBroadcaster static_broadcaster_;
  tf2_ros::TransformBroadcaster broadcaster_;
  ros::WallTimer timer_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
