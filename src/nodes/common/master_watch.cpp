#include "nodes/common/master_watch.h"

#include <XmlRpcClient.h>
#include <ros/network.h>
#include <ros/ros.h>
#include <ros/xmlrpc_manager.h>

#include <utility>

namespace markerless_mocap {
namespace {

using XmlRpc::XmlRpcValue;

constexpr double kInterval = 2.0;  // s
// s after the publishers, because the master tells a subscriber of those that it knows, and the
// subscriber drops all others.
constexpr double kSubscribersLater = 2.0 * kInterval;

XmlRpcValue valuesOf(const std::vector<std::string>& texts) {
  XmlRpcValue values;
  for (size_t i = 0; i < texts.size(); ++i) values[int(i)] = texts[i];
  return values;
}

/// Asks the master; false if it cannot be reached or refuses.
bool askMaster(const std::string& method, const std::vector<std::string>& arguments,
               XmlRpcValue* answer) {
  XmlRpcValue response;
  return ros::master::execute(method, valuesOf(arguments), response, *answer, false);
}

bool isKnownToMaster() {
  XmlRpcValue address;
  const std::string& node = ros::this_node::getName();
  return askMaster("lookupNode", {node, node}, &address);
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

}  // namespace

MasterWatch::MasterWatch(const std::vector<std::string>& namespaces) : namespaces_(namespaces) {
  keepParameters();
  thread_ = std::thread([this] { run(); });
}

MasterWatch::~MasterWatch() {
  stopping_ = true;
  thread_.join();
}

bool MasterWatch::sleep(double seconds) const {
  const ros::WallTime end = ros::WallTime::now() + ros::WallDuration(seconds);
  while (!stopping_ && ros::ok() && ros::WallTime::now() < end) ros::WallDuration(0.1).sleep();
  return !stopping_ && ros::ok();
}

void MasterWatch::run() {
  while (sleep(kInterval))
    if (!isKnownToMaster() && ros::master::check() && !isKnownToMaster()) registerAgain();
}

void MasterWatch::keepParameters() {
  for (const std::string& name : namespaces_) {
    XmlRpcValue values;
    if (askMaster("getParam", {ros::this_node::getName(), name}, &values))
      parameters_[name] = values;
  }
}

void MasterWatch::registerAgain() {
  ROS_ERROR_STREAM(ros::this_node::getName()
                   << ": roscore was started again; the topics and parameters of this node are "
                      "registered again, its services only when the node is started again");
  for (auto& [name, values] : parameters_) ros::param::set(name, values);
  registerPublishers();
  if (sleep(kSubscribersLater)) registerSubscribers();
}

}  // namespace markerless_mocap
