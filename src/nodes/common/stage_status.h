#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <cstdint>
#include <map>
#include <mutex>
#include <string>

#include "nodes/common/callback_gate.h"

namespace markerless_mocap {

/// State of a stage: published in /diagnostics once a second, and logged at most every five
/// seconds. Thread-safe.
class StageStatus {
 public:
  StageStatus(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
              const std::string& stage);

  /// The last frame set was processed successfully.
  void ok(const std::string& message);
  /// There is no error, but no output either.
  void waiting(const std::string& message);
  /// A frame set could not be used; `message` gives the reason.
  void problem(const std::string& message);
  /// Sets a counter that /diagnostics shows.
  void set(const std::string& name, uint64_t count);
  void count(const std::string& name);

 private:
  void enter(uint8_t level, const std::string& message);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::string stage_;
  diagnostic_updater::Updater updater_;
  std::mutex mutex_;
  uint8_t level_;
  std::string message_ = "starting";
  std::string last_problem_ = "none";
  std::map<std::string, uint64_t> counts_;
  ros::WallTimer timer_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
