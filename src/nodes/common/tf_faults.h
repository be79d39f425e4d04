#pragma once

#include <ros/message_event.h>
#include <ros/node_handle.h>
#include <tf2_msgs/TFMessage.h>

#include <map>
#include <mutex>
#include <string>

#include "nodes/common/callback_gate.h"
#include "nodes/common/stage_status.h"
#include "ros/rig_collector.h"
#include "ros/tf_refusal.h"

namespace markerless_mocap {

/// Tells of transforms that tf2 does not take, as long as none of the same frame comes that it
/// takes.
class TfFaults {
 public:
  explicit TfFaults(ros::NodeHandle handle) {
    for (const char* topic : {"/tf", "/tf_static"})
      subscribers_[topic] = handle.subscribe<tf2_msgs::TFMessage>(
          topic, 100, boost::function<void(const Event&)>(gate_.guarded([this](const Event& event) {
            receive(event);
          })));
  }
  /// Those on the way from a camera of the rig to the world.
  void tell(const RigCollector& rig, const tf2::BufferCore& tf, StageStatus* status) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const auto& [frame, sentence] : faults_)
      if (rig.dependsOn(frame, tf)) status->remark(sentence);
  }

 private:
  using Event = ros::MessageEvent<const tf2_msgs::TFMessage>;

  void receive(const Event& event) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (const geometry_msgs::TransformStamped& transform : event.getConstMessage()->transforms) {
      const std::string why = tfRefusal(transform);
      if (why.empty())
        faults_.erase(transform.child_frame_id);
      else if (faults_.size() < kMost)
        faults_[transform.child_frame_id] = event.getPublisherName() + " has sent a transform of " +
                                            transform.child_frame_id +
                                            " to tf that is not used: " + why;
    }
  }

  static constexpr size_t kMost = 256;
  std::mutex mutex_;
  std::map<std::string, std::string> faults_;  ///< by child frame
  std::map<std::string, ros::Subscriber> subscribers_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
