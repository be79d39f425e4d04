#include "nodes/pose_fitting/body_description.h"

#include <ros/this_node.h>

#include "nodes/common/master_answers.h"

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
  XmlRpc::XmlRpcValue answer;
  if (!set_) set_ = askMaster("setParam", {ros::this_node::getName(), parameter_, urdf_}, &answer);
}

void BodyDescription::remove() {
  XmlRpc::XmlRpcValue answer;
  if (set_) askMaster("deleteParam", {ros::this_node::getName(), parameter_}, &answer);
  set_ = false;
}

bool BodyDescription::isThere() const {
  XmlRpc::XmlRpcValue answer;
  if (!askMaster("hasParam", {ros::this_node::getName(), parameter_}, &answer))
    return true;  // nobody can tell
  return bool(answer);
}

void BodyDescription::forget() {
  set_ = false;
}

}  // namespace markerless_mocap
