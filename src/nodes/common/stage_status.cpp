#include "nodes/common/stage_status.h"

#include <ros/console.h>

namespace markerless_mocap {

using diagnostic_msgs::DiagnosticStatus;

StageStatus::StageStatus(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
                         const std::string& stage)
    : stage_(stage),
      updater_(handle, private_handle, private_handle.getNamespace()),
      level_(DiagnosticStatus::WARN) {
  updater_.setHardwareID("none");
  updater_.add(stage, this, &StageStatus::report);
  // By the wall clock, and forced: diagnostics continue while a bag is paused or loops.
  timer_ = handle.createWallTimer(
      ros::WallDuration(1.0),
      gate_.guarded([this](const ros::WallTimerEvent&) { updater_.force_update(); }));
}

void StageStatus::ok(const std::string& message) {
  enter(DiagnosticStatus::OK, message);
}

void StageStatus::waiting(const std::string& message) {
  enter(DiagnosticStatus::WARN, message);
  ROS_WARN_STREAM_THROTTLE(5.0, stage_ << ": " << message);
}

void StageStatus::problem(const std::string& message) {
  enter(DiagnosticStatus::WARN, message);
  count("problems");
  ROS_WARN_STREAM_THROTTLE(5.0, stage_ << ": " << message);
}

void StageStatus::set(const std::string& name, uint64_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_[name] = count;
}

void StageStatus::count(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts_[name];
}

void StageStatus::enter(uint8_t level, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  level_ = level;
  message_ = message;
  if (level != DiagnosticStatus::OK) last_problem_ = message;
}

void StageStatus::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.summary(level_, message_);
  for (const auto& [name, count] : counts_) status.add(name, count);
  status.add("last reason", last_problem_);
}

}  // namespace markerless_mocap
