#include "nodes/common/stage_status.h"

#include <ros/console.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "text/printable.h"

namespace markerless_mocap {

using diagnostic_msgs::DiagnosticStatus;

namespace {

constexpr double kRemarkTime = 10.0;  // s
constexpr size_t kMaxRemarks = 64, kShownRemarks = 3;
constexpr double kStartTime = 5.0;        // s until every camera should have sent
constexpr double kLongestLatency = 60.0;  // s; more is a stamp of another time, as of a recording
constexpr double kResultTime = 3.0;  // s that one frame set may take, as a search for a person does

/// For example "for 14.2 s, since 11:20:05".
std::string spanText(double seconds) {
  const std::time_t start = std::time(nullptr) - std::time_t(seconds + 0.5);
  std::tm local;
  localtime_r(&start, &local);
  char clock[16], text[64];
  std::strftime(clock, sizeof clock, "%H:%M:%S", &local);
  std::snprintf(text, sizeof text, "for %.1f s, since %s", seconds, clock);
  return text;
}

}  // namespace

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

void StageStatus::ok(const std::string& text) {
  enter(DiagnosticStatus::OK, printableLine(text));
}

void StageStatus::waiting(const std::string& text) {
  const std::string message = printableLine(text);
  enter(DiagnosticStatus::WARN, message);
  ROS_WARN_STREAM_THROTTLE(5.0, stage_ << ": " << message);
}

void StageStatus::problem(const std::string& text) {
  const std::string message = printableLine(text);
  enter(DiagnosticStatus::WARN, message);
  count("problems");
  ROS_WARN_STREAM_THROTTLE(5.0, stage_ << ": " << message);
}

void StageStatus::error(const std::string& text) {
  const std::string message = printableLine(text);
  enter(DiagnosticStatus::ERROR, message);
  count("problems");
  ROS_ERROR_STREAM_THROTTLE(5.0, stage_ << ": " << message);
}

void StageStatus::remark(const std::string& text) {
  const std::string message = printableLine(text);
  const std::lock_guard<std::mutex> lock(mutex_);
  for (Remark& known : remarks_) {
    if (known.message != message) continue;
    known.until = ros::SteadyTime::now().toSec() + kRemarkTime;
    return;
  }
  ROS_WARN_STREAM(stage_ << ": " << message);
  remarks_.push_back({message, ros::SteadyTime::now().toSec() + kRemarkTime});
  if (remarks_.size() > kMaxRemarks) remarks_.pop_front();
  last_problem_ = message;
}

void StageStatus::set(const std::string& name, uint64_t count) {
  const std::lock_guard<std::mutex> lock(mutex_);
  counts_[name] = count;
}

void StageStatus::count(const std::string& name) {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++counts_[name];
}

void StageStatus::sent(const ros::Time& stamp) {
  if (!ros::Time::isSystemTime()) return;
  const double latency = (ros::Time::now() - stamp).toSec();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (std::abs(latency) < kLongestLatency) latencies_.add(ros::SteadyTime::now().toSec(), latency);
}

size_t StageStatus::watch(const std::string& input, Loss loss) {
  const std::lock_guard<std::mutex> lock(mutex_);
  inputs_.push_back({input, loss, ros::SteadyTime::now().toSec(), {}});
  return inputs_.size() - 1;
}

void StageStatus::arrived(size_t input) {
  const std::lock_guard<std::mutex> lock(mutex_);
  inputs_.at(input).watch.arrived(ros::SteadyTime::now().toSec());
}

void StageStatus::enter(uint8_t level, const std::string& message) {
  const std::lock_guard<std::mutex> lock(mutex_);
  level_ = level;
  message_ = message;
  results_.arrived(ros::SteadyTime::now().toSec());
  if (level != DiagnosticStatus::OK) last_problem_ = message;
}

// An input that has never sent is told by StageInputs, unless others like it do send.
InputWatch::Silence StageStatus::silenceOf(const Input& input, double now) const {
  if (input.watch.last() || now - input.start < kStartTime) return input.watch.silence(now);
  const bool others_send = std::any_of(inputs_.begin(), inputs_.end(), [&](const Input& other) {
    return other.loss == input.loss && other.watch.last();
  });
  return others_send ? InputWatch::Silence::kLong : InputWatch::Silence::kNone;
}

StageStatus::Summary StageStatus::silenceOf(Loss loss, double now) const {
  Summary summary{DiagnosticStatus::OK, ""};
  size_t watched = 0, silent = 0;
  double shortest = 0.0;
  for (const Input& input : inputs_) {
    if (input.loss != loss) continue;
    ++watched;
    const InputWatch::Silence silence = silenceOf(input, now);
    if (silence == InputWatch::Silence::kNone) continue;
    const double since = now - input.watch.last().value_or(input.start);
    shortest = silent++ == 0 ? since : std::min(shortest, since);
    summary.message += (silent == 1 ? "no messages on " : ", ") + input.name;
    const bool is_error = loss == Loss::kStopsStage && silence == InputWatch::Silence::kLong;
    summary.level = std::max<uint8_t>(summary.level,
                                      is_error ? DiagnosticStatus::ERROR : DiagnosticStatus::WARN);
  }
  if (silent == 0) return summary;
  if (loss == Loss::kCostsCamera && silent == watched) {
    summary.level = DiagnosticStatus::ERROR;
    summary.message = "no silhouettes come from any camera";
  }
  summary.message += " " + spanText(shortest);
  return summary;
}

StageStatus::Summary StageStatus::ownState(double now) const {
  const bool is_old =
      results_.silence(now) == InputWatch::Silence::kLong && now - *results_.last() > kResultTime;
  if (level_ != DiagnosticStatus::OK || !is_old) return {level_, message_};
  return {DiagnosticStatus::WARN, "no result " + spanText(now - *results_.last())};
}

StageStatus::Summary StageStatus::summaryNow(double now) {
  Summary summary = ownState(now);
  for (const Loss loss : {Loss::kCostsSome, Loss::kCostsCamera, Loss::kStopsStage}) {
    const Summary silence = silenceOf(loss, now);
    if (silence.level == DiagnosticStatus::OK) continue;
    // What was said before the inputs stopped holds no longer.
    const bool stopped = silence.level == DiagnosticStatus::ERROR;
    summary.message = silence.message + (stopped ? "" : "; " + summary.message);
    summary.level = std::max(summary.level, silence.level);
  }
  remarks_.erase(std::remove_if(remarks_.begin(), remarks_.end(),
                                [now](const Remark& remark) { return remark.until < now; }),
                 remarks_.end());
  if (!remarks_.empty()) summary.level = std::max<uint8_t>(summary.level, DiagnosticStatus::WARN);
  for (size_t i = 0; i < std::min(remarks_.size(), kShownRemarks); ++i)
    summary.message += "; " + remarks_[remarks_.size() - 1 - i].message;
  if (remarks_.size() > kShownRemarks)
    summary.message += "; and " + std::to_string(remarks_.size() - kShownRemarks) + " more";
  return summary;
}

StageStatus::Summary StageStatus::summary() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return summaryNow(ros::SteadyTime::now().toSec());
}

void StageStatus::report(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const Summary now = summaryNow(ros::SteadyTime::now().toSec());
  if (now.level == DiagnosticStatus::ERROR && level_ != DiagnosticStatus::ERROR)
    ROS_ERROR_STREAM_THROTTLE(5.0, stage_ << ": " << now.message);
  status.summary(now.level, now.message);
  for (const auto& [name, count] : counts_) status.add(name, count);
  latencies_.forget(ros::SteadyTime::now().toSec());
  if (!latencies_.empty()) {
    status.add("camera to message, median ms", latencies_.milliseconds(0.5));
    status.add("camera to message, 99 % within ms", latencies_.milliseconds(0.99));
  }
  status.add("last reason", last_problem_);
}

}  // namespace markerless_mocap
