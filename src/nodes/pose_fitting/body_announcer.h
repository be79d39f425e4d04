#pragma once

#include <ros/node_handle.h>

#include <string>

namespace markerless_mocap {

/// Publishes on /humans/bodies/tracked which body is tracked (REP-155). Does nothing in a build
/// without hri_msgs.
class BodyAnnouncer {
 public:
  BodyAnnouncer(ros::NodeHandle& handle, std::string id);
  ~BodyAnnouncer();
  BodyAnnouncer(const BodyAnnouncer&) = delete;
  BodyAnnouncer& operator=(const BodyAnnouncer&) = delete;

  /// Publishes only if something has changed.
  void announce(bool tracked, const ros::Time& stamp);

 private:
  std::string id_;
  bool tracked_ = false;
  ros::Publisher publisher_;
};

}  // namespace markerless_mocap
