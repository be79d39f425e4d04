#include "nodes/pose_fitting/body_announcer.h"

#ifdef MOCAP_WITH_HRI_MSGS
#include <hri_msgs/IdsList.h>
#endif

namespace markerless_mocap {

BodyAnnouncer::BodyAnnouncer([[maybe_unused]] ros::NodeHandle& handle, std::string id)
    : id_(std::move(id)) {
#ifdef MOCAP_WITH_HRI_MSGS
  publisher_ = handle.advertise<hri_msgs::IdsList>("/humans/bodies/tracked", 1, true);
#endif
}

BodyAnnouncer::~BodyAnnouncer() {
  announce(false, ros::Time());
}

void BodyAnnouncer::announce(bool tracked, [[maybe_unused]] const ros::Time& stamp) {
  if (tracked == tracked_) return;
  tracked_ = tracked;
#ifdef MOCAP_WITH_HRI_MSGS
  hri_msgs::IdsList list;
  list.header.stamp = stamp;
  if (tracked) list.ids.push_back(id_);
  publisher_.publish(list);
#endif
}

}  // namespace markerless_mocap
