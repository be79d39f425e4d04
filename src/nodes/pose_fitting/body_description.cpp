#include "nodes/pose_fitting/body_description.h"

#include <ros/param.h>

namespace markerless_mocap {

BodyDescription::~BodyDescription() {
  if (set_) ros::param::del(parameter_);
}

void BodyDescription::set(const TrackedBody& body) {
  ros::param::set(parameter_, body.urdf);
  set_ = true;
}

}  // namespace markerless_mocap
