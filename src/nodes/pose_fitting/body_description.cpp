#include "nodes/pose_fitting/body_description.h"

#include <ros/param.h>

namespace markerless_mocap {

BodyDescription::~BodyDescription() {
  remove();
}

void BodyDescription::set(const TrackedBody& body) {
  urdf_ = body.urdf;
  set_ = false;
  restore();
}

void BodyDescription::restore() {
  if (!set_) ros::param::set(parameter_, urdf_);
  set_ = true;
}

void BodyDescription::remove() {
  if (set_) ros::param::del(parameter_);
  set_ = false;
}

}  // namespace markerless_mocap
