#include "nodes/pose_fitting/body_announcer.h"

#include "ros/ids_list.h"

namespace markerless_mocap {

BodyAnnouncer::BodyAnnouncer(ros::NodeHandle& handle, std::string id)
    : id_(std::move(id)), publisher_(handle.advertise<IdsList>(kTrackedBodies, 1, true)) {
  publish(ros::Time::now());
}

BodyAnnouncer::~BodyAnnouncer() {
  announce(false, ros::Time::now());
}

void BodyAnnouncer::announce(bool tracked, const ros::Time& stamp) {
  if (tracked == tracked_) return;
  tracked_ = tracked;
  publish(stamp);
}

void BodyAnnouncer::publish(const ros::Time& stamp) {
  IdsList list;
  list.header.stamp = stamp;
  if (tracked_) list.ids.push_back(id_);
  publisher_.publish(list);
}

}  // namespace markerless_mocap
