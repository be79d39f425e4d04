#pragma once

#include <ros/node_handle.h>

#include <functional>
#include <mutex>
#include <vector>

#include "nodes/common/callback_gate.h"
#include "ros/settings_conversions.h"

namespace markerless_mocap {

/// The topics and the service of a node that dynamic_reconfigure's clients look for, such as
/// rqt_reconfigure and dynparam. Their own server needs a struct per node that is generated from a
/// second list of all options.
class SettingsServer {
 public:
  /// \param handle private to the node, of several threads: a change may take a second
  /// \param change makes changes, which end in publish(), or throws why they cannot be used
  SettingsServer(const ros::NodeHandle& handle, const std::vector<Setting>& settings,
                 std::function<void(const SettingChanges&)> change);

  /// Tells the settings that are used now.
  void publish(const std::vector<Setting>& settings);

 private:
  using Config = dynamic_reconfigure::Config;
  void receive(const Config& wanted, Config* used);

  std::function<void(const SettingChanges&)> change_;
  std::mutex mutex_;  ///< of used_
  Config used_;
  ros::Publisher descriptions_, updates_;
  ros::ServiceServer service_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
