#include "nodes/common/master_watch.h"

#include <XmlRpcClient.h>
#include <diagnostic_msgs/DiagnosticArray.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <algorithm>
#include <utility>

#include "nodes/common/master_answers.h"
#include "nodes/common/process_limits.h"

namespace markerless_mocap {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double kInterval = 1.0;  // s
// s after the publishers, because the master tells a subscriber of those that it knows, and the
// subscriber drops all others.
constexpr double kSubscribersLater = 2.0 * kInterval;
constexpr double kTold = 10.0;  // s after roscore came back
constexpr const char* kStages[] = {"silhouette", "visual_hull", "body_segmentation", "pose_tree",
                                   "pose_fitting"};
constexpr const char* kRegisteredAgain =
    "roscore was started again; the topics, services and parameters of this node are registered "
    "again";

/// Asked by a service that every node has. The name of the node is no proof: a topic that was
/// subscribed since is enough for the master to know it.
bool isKnownToMaster() {
  XmlRpcValue address;
  const std::string& node = ros::this_node::getName();
  return askMaster("lookupService", {node, node + "/get_loggers"}, &address);
}

/// Calls this node's own interface for other nodes; [code, message, answer], empty if it failed.
XmlRpcValue askItself(const std::string& method, XmlRpcValue arguments) {
  std::string host;
  uint32_t port = 0;
  XmlRpcValue response;
  if (!ros::network::splitURI(ros::XMLRPCManager::instance()->getServerURI(), host, port))
    return {};
  XmlRpc::XmlRpcClient client(host.c_str(), int(port), "/");
  return client.execute(method.c_str(), arguments, response) ? response : XmlRpcValue();
}

/// Name and type of each topic that the node publishes, or subscribes to.
std::vector<std::pair<std::string, std::string>> topicsBy(const std::string& method) {
  std::vector<std::pair<std::string, std::string>> topics;
  XmlRpcValue response = askItself(method, valuesOf({ros::this_node::getName()}));
  if (response.getType() != XmlRpcValue::TypeArray || response.size() < 3) return topics;
  for (int i = 0; i < response[2].size(); ++i)
    topics.emplace_back(std::string(response[2][i][0]), std::string(response[2][i][1]));
  return topics;
}

void registerPublishers() {
  const std::string& uri = ros::XMLRPCManager::instance()->getServerURI();
  XmlRpcValue subscribers;
  for (const auto& [topic, type] : topicsBy("getPublications"))
    askMaster("registerPublisher", {ros::this_node::getName(), topic, type, uri}, &subscribers);
}

void registerSubscribers() {
  const std::string &uri = ros::XMLRPCManager::instance()->getServerURI(),
                    &node = ros::this_node::getName();
  for (const auto& [topic, type] : topicsBy("getSubscriptions")) {
    XmlRpcValue publishers;
    const bool known = askMaster("registerSubscriber", {node, topic, type, uri}, &publishers);
    if (!known || publishers.getType() != XmlRpcValue::TypeArray || publishers.size() == 0)
      continue;  // connections to nodes that do not register again go on
    XmlRpcValue arguments = valuesOf({"/master", topic});
    arguments[2] = publishers;
    askItself("publisherUpdate", arguments);
  }
}

/// The services that this node has registered, with their addresses.
std::map<std::string, std::string> registeredServices() {
  std::map<std::string, std::string> services;
  const std::string& node = ros::this_node::getName();
  XmlRpcValue state;
  if (!askMaster("getSystemState", {node}, &state)) return services;
  if (state.getType() != XmlRpcValue::TypeArray || state.size() < 3) return services;
  for (int i = 0; i < state[2].size(); ++i) {
    XmlRpcValue providers = state[2][i][1], address;
    const std::string name = state[2][i][0];
    for (int k = 0; k < providers.size(); ++k)
      if (std::string(providers[k]) == node && askMaster("lookupService", {node, name}, &address))
        services[name] = std::string(address);
  }
  return services;
}

}  // namespace

MasterWatch::MasterWatch(const std::vector<std::string>& namespaces)
    : namespaces_(namespaces), services_(registeredServices()) {
  std::vector<std::string> kept = namespaces;
  if (!namespaces.empty())
    for (const char* stage : kStages)
      kept.push_back(ros::names::parentNamespace(namespaces[0]) + "/" + stage);
  keepParameters(kept);
  diagnostics_ = ros::NodeHandle().advertise<diagnostic_msgs::DiagnosticArray>("/diagnostics", 1);
  thread_ = std::thread([this] { run(); });
}

MasterWatch::~MasterWatch() {
  stopping_ = true;
  thread_.join();
}

bool MasterWatch::sleep(double seconds) const {
  const ros::SteadyTime end = ros::SteadyTime::now() + ros::WallDuration(seconds);
  while (!stopping_ && ros::ok() && ros::SteadyTime::now() < end) ros::WallDuration(0.1).sleep();
  return !stopping_ && ros::ok();
}

void MasterWatch::run() {
  while (sleep(kInterval)) {
    if (ros::SteadyTime::now() < told_until_) tell("roscore", kRegisteredAgain);
    if (const std::string shortage = shortageOfFiles(); !shortage.empty()) tell("limits", shortage);
    if (isKnownToMaster()) {
      keepParameters(namespaces_);  // settings may have changed
      continue;
    }
    if (!masterAnswers())
      tell("roscore", "roscore cannot be reached; this node goes on with those that it knows");
    else if (!isKnownToMaster())
      registerAgain();
  }
}

void MasterWatch::tell(const std::string& about, const std::string& message) const {
  diagnostic_msgs::DiagnosticArray array;
  array.header.stamp = ros::Time::now();
  array.status.emplace_back();
  array.status[0].level = diagnostic_msgs::DiagnosticStatus::WARN;
  array.status[0].name = ros::this_node::getName().substr(1) + ": " + about;
  array.status[0].message = message;
  diagnostics_.publish(array);
}

void MasterWatch::keepParameters(const std::vector<std::string>& namespaces) {
  for (const std::string& name : namespaces) {
    XmlRpcValue values;
    if (askMaster("getParam", {ros::this_node::getName(), ros::names::clean(name)}, &values))
      parameters_[ros::names::clean(name)] = values;
  }
}

/// Those of other stages only if nobody has set them: these know them better.
void MasterWatch::setParameters() const {
  for (const auto& [name, values] : parameters_) {
    const bool own = std::count(namespaces_.begin(), namespaces_.end(), name) > 0;
    if (own || !ros::param::has(name)) ros::param::set(name, values);
  }
}

void MasterWatch::registerAgain() {
  ROS_ERROR_STREAM(ros::this_node::getName() << ": " << kRegisteredAgain);
  told_until_ = ros::SteadyTime::now() + ros::WallDuration(kTold);
  setParameters();
  registerPublishers();
  XmlRpcValue ignored;
  for (const auto& [name, address] : services_)
    askMaster(
        "registerService",
        {ros::this_node::getName(), name, address, ros::XMLRPCManager::instance()->getServerURI()},
        &ignored);
  if (sleep(kSubscribersLater)) registerSubscribers();
}

}  // namespace markerless_mocap
