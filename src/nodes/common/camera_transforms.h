#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include "nodes/common/callback_gate.h"
#include "nodes/common/stage_status.h"
#include "ros/latest_transforms.h"

namespace markerless_mocap {

/// Where tf places the cameras now, whatever the senders' clocks say.
class CameraTransforms {
 public:
  explicit CameraTransforms(ros::NodeHandle handle)
      : moving_(subscribe(handle, "/tf", false)), fixed_(subscribe(handle, "/tf_static", true)) {}

  const tf2::BufferCore& buffer() const { return latest_.buffer(); }
  /// Tells of transforms that tf2 does not take.
  void tellFaults(const RigCollector& rig, StageStatus* status) const {
    for (const std::string& sentence : latest_.faults(rig)) status->remark(sentence);
  }

 private:
  using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;

  ros::Subscriber subscribe(ros::NodeHandle& handle, const std::string& topic, bool is_static) {
    return handle.subscribe<tf2_msgs::TFMessage>(
        topic, 100,
        boost::function<void(const Event&)>(gate_.guarded([this, is_static](const Event& event) {
          latest_.add(*event.getConstMessage(), event.getPublisherName(), is_static,
                      ros::SteadyTime::now().toNSec());
        })));
  }

  LatestTransforms latest_;
  CallbackGate gate_;  // made before what it guards
  ros::Subscriber moving_, fixed_;
};

}  // namespace markerless_mocap
