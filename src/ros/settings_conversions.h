#pragma once

#include <dynamic_reconfigure/Config.h>
#include <dynamic_reconfigure/ConfigDescription.h>
#include <ros/node_handle.h>

#include <set>
#include <string>
#include <vector>

#include "options/settings.h"

namespace markerless_mocap {

/// Settings as dynamic_reconfigure describes them: one group "Default"; a text with few allowed
/// values is an enumeration.
dynamic_reconfigure::ConfigDescription messageFromSettings(const std::vector<Setting>& settings);
/// Their values.
dynamic_reconfigure::Config valuesMessage(const std::vector<Setting>& settings);
SettingChanges changesFromMessage(const dynamic_reconfigure::Config& config);

/// Sets the parameters of the options that have one of these settings, so that a node that starts
/// again uses them.
class ParameterWriter : public SettingVisitor {
 public:
  /// \param handle in whose namespace the parameters are \param changes whose names are written
  ParameterWriter(ros::NodeHandle handle, std::set<std::string> fixed,
                  const SettingChanges& changes)
      : SettingVisitor(std::move(fixed)), handle_(std::move(handle)), changes_(changes) {}

 private:
  void visitSetting(const std::string& path, const OptionField& field) override;

  ros::NodeHandle handle_;
  const SettingChanges& changes_;
};

}  // namespace markerless_mocap
