#pragma once

#include <ros/node_handle.h>
#include <sensor_msgs/PointCloud2.h>
#include <tf2_ros/transform_broadcaster.h>

#include "markerless_mocap/camera/instant_assembler.h"
#include "markerless_mocap/fitting/pose_tracker.h"
#include "markerless_mocap/ros/messages.h"
#include "markerless_mocap/ros/node_options.h"
#include "nodes/body_announcer.h"
#include "nodes/body_description.h"
#include "nodes/callback_gate.h"
#include "nodes/stage_status.h"

namespace markerless_mocap {

/// Joins parts, labels and hull of one stamp and follows the person. Its callbacks come one at a
/// time.
class FittingStage {
 public:
  FittingStage(ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
               const FittingOptions& options, const FittingNodeOptions& node_options);

 private:
  enum Stream : size_t { kParts, kLabels, kHull, kStreams };
  /// A message of one of the streams.
  struct Item {
    BodyPartsMsg::ConstPtr parts;
    sensor_msgs::PointCloud2ConstPtr cloud;
  };

  void subscribe(ros::NodeHandle& handle);
  void receive(Stream stream, const std_msgs::Header& header, Item item);
  BodyPose fit(const InstantAssembler<Item>::Instant& instant);
  void publish(const BodyPose& pose, const std_msgs::Header& header);

  BodyDescription description_;
  PoseTracker tracker_;
  InstantAssembler<Item> assembler_;
  StageStatus status_;
  VoxelGridConstPtr grid_;
  ros::Publisher joint_states_, pose_;
  tf2_ros::TransformBroadcaster broadcaster_;
  BodyAnnouncer announcer_;
  std::vector<ros::Subscriber> subscribers_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
