#pragma once

#include <XmlRpcValue.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace markerless_mocap {

/// Texts as the arguments of a question.
inline XmlRpc::XmlRpcValue valuesOf(const std::vector<std::string>& texts) {
  XmlRpc::XmlRpcValue values;
  for (size_t i = 0; i < texts.size(); ++i) values[int(i)] = texts[i];
  return values;
}

/// Asks roscore; false if it is away or refuses. Never waits for it, as ros::param and
/// ros::master::getTopics do: poses go on without roscore.
inline bool askMaster(const std::string& method, const std::vector<std::string>& arguments,
                      XmlRpc::XmlRpcValue* answer) {
  XmlRpc::XmlRpcValue response;
  return ros::master::execute(method, valuesOf(arguments), response, *answer, false);
}

/// Whether roscore answers. To be asked before a topic is subscribed while poses are wanted, as
/// that waits for a roscore that is away until it is back.
inline bool masterAnswers() {
  return ros::master::check();
}

/// The types of the advertised topics by their names; nothing if roscore is away.
inline std::optional<std::map<std::string, std::string>> advertisedTopics() {
  XmlRpc::XmlRpcValue answer;
  if (!askMaster("getPublishedTopics", {ros::this_node::getName(), ""}, &answer)) return {};
  std::map<std::string, std::string> types;
  for (int i = 0; i < answer.size(); ++i)
    types[std::string(answer[i][0])] = std::string(answer[i][1]);
  return types;
}

}  // namespace markerless_mocap
