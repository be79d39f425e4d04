#pragma once

#include <ros/node_handle.h>
#include <yaml-cpp/yaml.h>

#include <string>
#include <tuple>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// A value of the parameter server as YAML. Throws std::invalid_argument on dates and binary data,
/// which no option has. \param name of the value, for that sentence
YAML::Node yamlFromXmlRpc(const XmlRpc::XmlRpcValue& value, const std::string& name = "parameter");

/// All parameters in the namespace of a node handle as one YAML map; empty if there are none.
YAML::Node parametersOf(const ros::NodeHandle& handle);

/// Fills several option structs from one map, such as the options of a stage and of its node.
/// Throws std::invalid_argument on a key that belongs to none of them, and as `loadOptions`.
/// All structs have the same kStage. \param where name of the node for error messages
template <class... OptionsT>
void loadOptionsTogether(const YAML::Node& node, const std::string& where, OptionsT&... options) {
  using First = std::tuple_element_t<0, std::tuple<OptionsT...>>;
  OptionReader reader(node, where, First::kStage);
  (options.visit(reader), ...);
  reader.finish();
  (options.validate(), ...);
}

}  // namespace markerless_mocap
