#pragma once

#include <ros/node_handle.h>

#include <string>

namespace markerless_mocap {

/// Publishes on /humans/bodies/tracked which body is tracked (REP-155): latched, at the start an
/// empty list, so that clients drop what a node that ended without a word has announced.
class BodyAnnouncer {
 public:
  BodyAnnouncer(ros::NodeHandle& handle, std::string id);
  ~BodyAnnouncer();
  BodyAnnouncer(const BodyAnnouncer&) = delete;
  BodyAnnouncer& operator=(const BodyAnnouncer&) = delete;

  /// Publishes only if something has changed.
  void announce(bool tracked, const ros::Time& stamp);
  bool isTracked() const { return tracked_; }

 private:
  void publish(const ros::Time& stamp);

  std::string id_;
  bool tracked_ = false;
  ros::Publisher publisher_;
};

}  // namespace markerless_mocap
