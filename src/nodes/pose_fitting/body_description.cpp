#include "nodes/pose_fitting/body_description.h"

#include <ros/master.h>
#include <ros/this_node.h>

namespace markerless_mocap {
namespace {

/// As ros::param, but without waiting for a roscore that is gone: poses go on without it.
bool askMaster(const char* method, const std::string& parameter, const std::string* value,
               XmlRpc::XmlRpcValue* answer) {
  XmlRpc::XmlRpcValue request, response;
  request[0] = ros::this_node::getName();
  request[1] = parameter;
  if (value) request[2] = *value;
  return ros::master::execute(method, request, response, *answer, false);
}

}  // namespace

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
  if (!set_) set_ = askMaster("setParam", parameter_, &urdf_, &answer);
}

void BodyDescription::remove() {
  XmlRpc::XmlRpcValue answer;
  if (set_) askMaster("deleteParam", parameter_, nullptr, &answer);
  set_ = false;
}

bool BodyDescription::isThere() const {
  XmlRpc::XmlRpcValue answer;
  if (!askMaster("hasParam", parameter_, nullptr, &answer)) return true;  // nobody can tell
  return bool(answer);
}

void BodyDescription::forget() {
  set_ = false;
}

}  // namespace markerless_mocap
