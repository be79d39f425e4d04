#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "nodes/common/callback_gate.h"
#include "nodes/common/camera_image.h"
#include "nodes/common/low_latency_transport.h"
#include "nodes/common/message_pool.h"
#include "nodes/common/sender_watch.h"
#include "nodes/common/stage_status.h"

namespace markerless_mocap {

/// The subscriptions of a stage; their callbacks run one at a time. For each topic that is not
/// optional, a warning is given every five seconds until its first message, and the stage's status
/// tells when it falls silent. Where several nodes send on a topic, one of them counts. Declare
/// this last in its owner, so that it is destroyed first.
class StageInputs {
 public:
  enum Need {
    kOptional,
    kOnce,      ///< its first message is needed
    kRequired,  ///< without it there is no output
    kHelpful,   ///< without it the output is poorer
    kCamera,    ///< one of several cameras
  };

  /// \param status must outlive this object
  StageInputs(const ros::NodeHandle& handle, StageStatus* status)
      : handle_(handle), status_(status) {}

  /// \param callback takes a shared pointer to the message, or a ros::MessageEvent
  template <class MessageT, class CallbackT>
  void listen(const std::string& topic, uint32_t queue, Need need, CallbackT callback) {
    subscribers_.push_back(subscribe<MessageT>(topic, queue, need, callback));
  }
  /// A topic whose last message stands until there is another one: its sender is never silent, so
  /// that of several the last one counts, which is told.
  template <class MessageT, class CallbackT>
  void listenToLatched(const std::string& topic, Need need, CallbackT callback) {
    subscribers_.push_back(subscribe<MessageT>(topic, 1, need, callback, true));
  }
  /// \param transport raw or compressed
  void listenToImages(const std::string& camera, const std::string& transport, uint32_t queue,
                      Need need, const std::function<void(const CameraImage&)>& callback) {
    subscribers_.push_back(subscribeToImages(camera, transport, queue, need, callback));
  }
  /// The masks of one of several cameras as images. A compressed one that cannot be read is
  /// counted and told, and is left out. \param transport raw or compressed
  void listenToMasks(const std::string& camera, const std::string& transport, uint32_t queue,
                     const std::function<void(const sensor_msgs::ImageConstPtr&)>& callback);
  /// As listenToImages(), until the result is destroyed.
  ros::Subscriber subscribeToImages(const std::string& camera, const std::string& transport,
                                    uint32_t queue, Need need,
                                    const std::function<void(const CameraImage&)>& callback);

  /// As listen(), until the result is destroyed.
  template <class MessageT, class CallbackT>
  ros::Subscriber subscribe(const std::string& topic, uint32_t queue, Need need, CallbackT callback,
                            bool latched = false) {
    const std::string name = handle_.resolveName(topic);
    if (need != kOptional) require(name, ros::message_traits::DataType<MessageT>::value());
    const std::optional<size_t> watched = watch(name, need);
    using Event = ros::MessageEvent<const MessageT>;
    ros::SubscribeOptions options;
    options.template initByFullCallbackType<const Event&>(
        name, queue,
        gate_.guarded([this, name, watched, callback, latched,
                       senders = std::make_shared<SenderWatch>()](const Event& event) {
          if (!isUsable(name, event.getPublisherName(), senders.get())) return;
          if (latched) tellIfAnother(name, *senders);
          silent_.erase(name);
          if (watched) status_->arrived(*watched);
          if constexpr (std::is_invocable_v<CallbackT, const Event&>)
            callback(event);
          else
            callback(event.getConstMessage());
        }),
        [pool = std::make_shared<MessagePool<MessageT>>()] { return pool->take(); });
    options.transport_hints = lowLatencyTransport();
    return handle_.subscribe(options);
  }

 private:
  void require(const std::string& topic, const std::string& type);
  /// The number of the topic in the status; none if it may be silent.
  std::optional<size_t> watch(const std::string& topic, Need need);
  void reportSilence();
  /// Tells if another node's messages are used.
  bool isUsable(const std::string& topic, const std::string& sender, SenderWatch* senders);
  void tellIfAnother(const std::string& topic, const SenderWatch& senders);

  ros::NodeHandle handle_;
  StageStatus* status_;
  std::map<std::string, std::string> silent_;  ///< required topics without messages so far, with
                                               ///< their types
  ros::WallTimer silence_timer_;
  std::vector<ros::Subscriber> subscribers_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
