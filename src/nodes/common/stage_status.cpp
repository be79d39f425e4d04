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
  // By the wall clock, and forced: a paused or looping bag must not silence the diagnostics.
  timer_ = handle.createWallTimer(
      ros::WallDuration(1.0),
      gate_.guarded([this](const ros::WallTimerEvent&) { updater_.force_update(); }));
}

void StageStatus::good(const std::string& sentence) {
  enter(DiagnosticStatus::OK, sentence);
}

void StageStatus::waiting(const std::string& sentence) {
  enter(DiagnosticStatus::WARN, sentence);
  ROS_WARN_STREAM_THROTTLE(5.0, stage_ << ": " << sentence);
}

void StageStatus::problem(const std::string& sentence) {
  enter(DiagnosticStatus::WARN, sentence);
  count("problems");
  ROS_WARN_STREAM_THROTTLE(5.0, stage_ << ": " << sentence);
}

void StageStatus::set(const std::string& name, uint64_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_[name] = count;
}

void StageStatus::count(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts_[name];
}

void StageStatus::enter(uint8_t level, const std::string& sentence) {
  const std::lock_guard<std::mutex> lock(mutex_);
  level_ = level;
  sentence_ = sentence;
  if (level != DiagnosticStatus::OK) last_problem_ = sentence;
}

void StageStatus::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  status.summary(level_, sentence_);
  for (const auto& [name, count] : counts_) status.add(name, count);
  status.add("last reason", last_problem_);
}

}  // namespace markerless_mocap
