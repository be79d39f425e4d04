#include "ros/parameters.h"

#include <ros/param.h>

#include <stdexcept>

namespace markerless_mocap {

YAML::Node yamlFromXmlRpc(const XmlRpc::XmlRpcValue& value, const std::string& name) {
  // XmlRpcValue lacks const accessors for some types, so a copy is read.
  XmlRpc::XmlRpcValue v(value);
  switch (v.getType()) {
    case XmlRpc::XmlRpcValue::TypeInvalid:
      return YAML::Node(YAML::NodeType::Null);
    case XmlRpc::XmlRpcValue::TypeBoolean:
      return YAML::Node(static_cast<bool>(v));
    case XmlRpc::XmlRpcValue::TypeInt:
      return YAML::Node(static_cast<int>(v));
    case XmlRpc::XmlRpcValue::TypeDouble:
      return YAML::Node(static_cast<double>(v));
    case XmlRpc::XmlRpcValue::TypeString:
      return YAML::Node(static_cast<std::string>(v));
    case XmlRpc::XmlRpcValue::TypeArray: {
      YAML::Node list(YAML::NodeType::Sequence);
      for (int i = 0; i < v.size(); ++i) list.push_back(yamlFromXmlRpc(v[i], name));
      return list;
    }
    case XmlRpc::XmlRpcValue::TypeStruct: {
      YAML::Node map(YAML::NodeType::Map);
      for (const auto& entry : v)
        map[entry.first] = yamlFromXmlRpc(entry.second, name + "/" + entry.first);
      return map;
    }
    default:
      throw std::invalid_argument(
          name + " is a date or binary data, allowed are texts, numbers, lists and maps");
  }
}

YAML::Node parametersOf(const ros::NodeHandle& handle) {
  XmlRpc::XmlRpcValue value;
  if (!ros::param::get(handle.getNamespace(), value)) return YAML::Node(YAML::NodeType::Map);
  return yamlFromXmlRpc(value, handle.getNamespace());
}

}  // namespace markerless_mocap
