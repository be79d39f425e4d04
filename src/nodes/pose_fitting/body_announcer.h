#pragma once

#include <ros/node_handle.h>

#include <string>

namespace markerless_mocap {

/// Says on /humans/bodies/tracked which body is there, for stacks after REP-155. Does nothing in a
/// build without hri_msgs.
class BodyAnnouncer {
 public:
  BodyAnnouncer(ros::NodeHandle& handle, std::string id);
  ~BodyAnnouncer();
  BodyAnnouncer(const BodyAnnouncer&) = delete;
  BodyAnnouncer& operator=(const BodyAnnouncer&) = delete;

  /// Publishes only when something has changed.
  void announce(bool tracked, const ros::Time& stamp);

 private:
  std::string id_;
  bool tracked_ = false;
  ros::Publisher publisher_;
};

}  // namespace markerless_mocap
