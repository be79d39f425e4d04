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

/// Publishes the studio's film, an instant per tick, and the truth beside it. A machine too slow
/// for the frame rate sees the film in slow motion.
class StudioStage {
 public:
  StudioStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
              const StudioOptions& options, const StudioNodeOptions& node_options);

 private:
  void advertise(ros::NodeHandle& handle);
  void publishRig();
  bool isAwaited() const;
  void tick();
  void publish(const StudioFrameSet& instant, const ros::Time& stamp);
  void publishCamera(size_t camera, const StudioFrameSet& instant, const std_msgs::Header& header);
  void publishTruth(const StudioFrameSet& instant, const std_msgs::Header& header);

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
