#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>
#include <utility>

#include "nodes/common/settings_server.h"

namespace markerless_mocap {

/// Options that can be changed while the node runs, by dynamic_reconfigure or by the node itself.
/// Changes are made together or not at all. Thread-safe. Declare it after all that `apply` uses, so
/// that it is destroyed first.
template <class OptionsT>
class LiveOptions {
 public:
  /// \param handle private to the node, of several threads
  /// \param fixed keys and sections that cannot be changed
  /// \param apply takes the new options, which are valid, for the frame sets that come; throws why
  ///   they cannot be used, then the old ones stay
  LiveOptions(const ros::NodeHandle& handle, const OptionsT& options, std::set<std::string> fixed,
              std::function<void(const OptionsT&)> apply)
      : handle_(handle),
        options_(options),
        fixed_(std::move(fixed)),
        apply_(std::move(apply)),
        server_(handle, settingsOf(options, fixed_),
                [this](const SettingChanges& changes) { change(changes); }) {}

  /// Throws std::invalid_argument with the loader's sentence if a value is not allowed, and what
  /// `apply` throws.
  void change(const SettingChanges& changes) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const OptionsT wanted = withChanges(options_, fixed_, changes);
    apply_(wanted);
    options_ = wanted;
    ParameterWriter writer(handle_, fixed_, changes);
    options_.visit(writer);
    server_.publish(settingsOf(options_, fixed_));
  }

  OptionsT options() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return options_;
  }

 private:
  ros::NodeHandle handle_;
  mutable std::mutex mutex_;
  OptionsT options_;
  std::set<std::string> fixed_;
  std::function<void(const OptionsT&)> apply_;
  SettingsServer server_;
};

}  // namespace markerless_mocap
