#pragma once

#include <ros/node_handle.h>
#include <ros/subscriber.h>
#include <sensor_msgs/PointCloud2.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "markerless_mocap/ros/messages.h"
#include "markerless_mocap/tracking/product_source.h"
#include "nodes/common/stage_inputs.h"
#include "nodes/pose_fitting/converted_products.h"
#include "nodes/pose_fitting/recent_messages.h"

namespace markerless_mocap {

/// Hulls, parts and trees that the other stages publish. Where they are needed to start only, they
/// are subscribed while a tracker asks for them and some seconds longer; nobody else needs parts
/// and trees, so their stages rest meanwhile. Thread-safe.
class LiveProducts {
 public:
  /// The products for one frame set. They are converted when they are asked for; messages that
  /// cannot be used are told.
  class Source : public ProductSource {
   public:
    Source(LiveProducts* products, int64_t stamp_ns) : all_(*products), stamp_ns_(stamp_ns) {}
    const FrameProducts& ofThisFrame() override;
    const VisualHull& newestHull() override;
    const FrameProducts& forStart() override;
    /// Message part that names a stage that was waited for without result; else empty.
    const std::string& lack() const { return lack_; }

   private:
    LiveProducts& all_;
    int64_t stamp_ns_;
    std::unique_ptr<FrameProducts> of_this_frame_;
    std::unique_ptr<VisualHull> newest_hull_;
    std::string lack_;
  };

  /// \param status of the stage; must outlive this object
  /// \param always subscribe to hulls and parts at once and for good; `hull_came` is then called
  ///   for each hull. Such a method needs no trees
  /// \param search_begins called when a tracker asks for the products of a start
  LiveProducts(StageInputs* inputs, StageStatus* status, int64_t tolerance_ns, bool always,
               std::function<void(const std_msgs::Header&)> hull_came,
               std::function<void()> search_begins);
  ~LiveProducts();

  Source at(const ros::Time& stamp);
  /// Ends all waiting.
  void close();
  /// To be called now and then: ends subscriptions that nobody needs any more.
  void rest();

 private:
  struct Messages : ProductMessages {
    std::string lack;
  };

  enum Asked { kHulls, kAll };
  void ask(Asked what);
  void subscribeToHulls();
  void subscribeToOthers();
  template <class MessageT>
  ros::Subscriber listen(const char* topic, RecentMessages<MessageT>* recent);
  /// Waits for the messages of this time.
  Messages wait(int64_t stamp_ns);
  /// Empty if there is none.
  VisualHull newestHull(int64_t stamp_ns);
  void tell(const std::vector<std::string>& faults);

  StageInputs* inputs_;
  StageStatus* status_;
  int64_t tolerance_ns_;
  bool always_;
  std::function<void(const std_msgs::Header&)> hull_came_;
  std::function<void()> search_begins_;
  std::mutex subscribing_;  ///< for the subscribers
  ros::Subscriber hull_subscriber_;
  std::vector<ros::Subscriber> other_subscribers_;
  std::mutex mutex_;  ///< for all below
  std::condition_variable changed_;
  bool closed_ = false;
  /// s of the steady clock, when a tracker asked last for hulls, and for the others
  double asked_for_hulls_ = 0.0, asked_for_others_ = 0.0;
  HullGrids grids_;
  RecentMessages<sensor_msgs::PointCloud2> hulls_, labels_;
  RecentMessages<BodyPartsMsg> parts_;
  RecentMessages<PoseTreeMsg> trees_;
};

}  // namespace markerless_mocap
