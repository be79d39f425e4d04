#include "ros/settings_conversions.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

using dynamic_reconfigure::Config;

template <class MessageT, class ValueT>
MessageT named(const std::string& name, const ValueT& value) {
  MessageT message;
  message.name = name;
  message.value = value;
  return message;
}

struct AddTo {
  Config* config;
  const std::string& name;
  void operator()(bool value) const {
    config->bools.push_back(named<dynamic_reconfigure::BoolParameter>(name, value));
  }
  void operator()(int value) const {
    config->ints.push_back(named<dynamic_reconfigure::IntParameter>(name, value));
  }
  void operator()(double value) const {
    config->doubles.push_back(named<dynamic_reconfigure::DoubleParameter>(name, value));
  }
  void operator()(const std::string& value) const {
    config->strs.push_back(named<dynamic_reconfigure::StrParameter>(name, value));
  }
};

/// The bound of a number; of another type any value, as clients expect one for each setting.
struct BoundOf {
  double bound;
  Setting::Value operator()(bool) const { return bound > 0.0; }
  Setting::Value operator()(int) const { return int(bound); }
  Setting::Value operator()(double) const { return bound; }
  Setting::Value operator()(const std::string&) const { return std::string(); }
};

const char* typeOf(const Setting::Value& value) {
  constexpr const char* kTypes[] = {"bool", "int", "double", "str"};  // in the variant's order
  return kTypes[value.index()];
}

/// A Python expression, as the clients evaluate it.
std::string enumerationOf(const std::vector<std::string>& words) {
  if (words.empty()) return "";
  std::string list;
  for (const std::string& word : words)
    list += (list.empty() ? "" : ", ") + ("{'name': '" + word + "', 'value': '" + word) +
            "', 'type': 'str', 'description': ''}";
  return "{'enum': [" + list + "], 'enum_description': ''}";
}

Config withDefaultGroup() {
  Config config;
  dynamic_reconfigure::GroupState group;
  group.name = "Default";
  group.state = true;
  config.groups.push_back(group);
  return config;
}

}  // namespace

Config valuesMessage(const std::vector<Setting>& settings) {
  Config config = withDefaultGroup();
  for (const Setting& setting : settings) std::visit(AddTo{&config, setting.name}, setting.value);
  return config;
}

dynamic_reconfigure::ConfigDescription messageFromSettings(const std::vector<Setting>& settings) {
  dynamic_reconfigure::ConfigDescription description;
  dynamic_reconfigure::Group group;
  group.name = "Default";
  description.min = description.max = withDefaultGroup();
  description.dflt = valuesMessage(settings);
  for (const Setting& setting : settings) {
    dynamic_reconfigure::ParamDescription parameter;
    parameter.name = setting.name;
    parameter.type = typeOf(setting.value);
    parameter.description = setting.meaning;
    parameter.edit_method = enumerationOf(setting.allowed);
    group.parameters.push_back(parameter);
    const double high = std::holds_alternative<bool>(setting.value) ? 1.0 : setting.max_value;
    std::visit(AddTo{&description.min, setting.name},
               std::visit(BoundOf{setting.min_value}, setting.value));
    std::visit(AddTo{&description.max, setting.name}, std::visit(BoundOf{high}, setting.value));
  }
  description.groups.push_back(group);
  return description;
}

SettingChanges changesFromMessage(const Config& config) {
  SettingChanges changes;
  for (const auto& p : config.bools) changes[p.name] = bool(p.value);
  for (const auto& p : config.ints) changes[p.name] = int(p.value);
  for (const auto& p : config.doubles) changes[p.name] = double(p.value);
  for (const auto& p : config.strs) changes[p.name] = std::string(p.value);
  return changes;
}

namespace {

struct SetParameter {
  const ros::NodeHandle& handle;
  const std::string& key;
  template <class T>
  void operator()(const T* value) const {
    handle.setParam(key, *value);
  }
  void operator()(const OptionField::Range& range) const {
    handle.setParam(key, std::vector<double>{*range.min, *range.max});
  }
  void operator()(const Eigen::Vector3d* v) const {
    handle.setParam(key, std::vector<double>(v->data(), v->data() + 3));
  }
};

}  // namespace

void ParameterWriter::visitSetting(const std::string& path, const OptionField& field) {
  const std::vector<std::string> names = settingNames(settingPrefix(path), field);
  const bool changed = std::any_of(names.begin(), names.end(),
                                   [&](const auto& name) { return changes_.count(name) > 0; });
  if (changed) std::visit(SetParameter{handle_, path + field.key}, field.value);
}

}  // namespace markerless_mocap
