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

/// What a stage says about itself: in /diagnostics once a second, and in the log at most every
/// five seconds. Safe to use from several callbacks at once.
class StageStatus {
 public:
  StageStatus(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
              const std::string& stage);

  /// The last instant went well.
  void good(const std::string& sentence);
  /// Nothing is wrong yet, but there is no output either.
  void waiting(const std::string& sentence);
  /// An instant could not be used, for the reason given.
  void problem(const std::string& sentence);
  /// Shows a number beside the state.
  void set(const std::string& name, uint64_t count);
  void count(const std::string& name);

 private:
  void enter(uint8_t level, const std::string& sentence);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);

  std::string stage_;
  diagnostic_updater::Updater updater_;
  std::mutex mutex_;
  uint8_t level_;
  std::string sentence_ = "starting";
  std::string last_problem_ = "none";
  std::map<std::string, uint64_t> counts_;
  ros::WallTimer timer_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
