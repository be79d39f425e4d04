#pragma once

#include <diagnostic_updater/diagnostic_updater.h>
#include <ros/node_handle.h>
#include <ros/wall_timer.h>

#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "nodes/common/callback_gate.h"
#include "nodes/common/input_watch.h"
#include "nodes/common/latency_meter.h"

namespace markerless_mocap {

/// State of a stage: published in /diagnostics once a second, and logged at most every five
/// seconds. What a stage says of itself expires: once its inputs, or its results, have stopped,
/// that is told instead. Thread-safe.
class StageStatus {
 public:
  /// How much a stage needs an input.
  enum class Loss {
    kStopsStage,   ///< without it there is no output: an error
    kCostsSome,    ///< a warning
    kCostsCamera,  ///< a warning; if all of these are silent, an error
  };
  struct Summary {
    uint8_t level;  ///< of diagnostic_msgs/DiagnosticStatus
    std::string message;
  };

  StageStatus(const ros::NodeHandle& handle, const ros::NodeHandle& private_handle,
              const std::string& stage);

  /// The last frame set was processed successfully.
  void ok(const std::string& text);
  /// There is no error, but no output either.
  void waiting(const std::string& text);
  /// A frame set could not be used; `text` gives the reason.
  void problem(const std::string& text);
  /// Nothing can be used until somebody acts.
  void error(const std::string& text);
  /// Something has happened that matters beyond this frame set: it is logged once, and a
  /// warning until ten seconds after it was last said.
  void remark(const std::string& text);
  /// Sets a counter that /diagnostics shows.
  void set(const std::string& name, uint64_t count);
  void count(const std::string& name);

  /// A result is on its way: /diagnostics shows how long it took since the camera's stamp. Of
  /// simulated time, and of stamps that are not of now, nothing is shown.
  void sent(const ros::Time& stamp);

  /// Declares an input; returns its number. Its silence is told by this name.
  size_t watch(const std::string& input, Loss loss);
  void arrived(size_t input);

  /// What /diagnostics shows now.
  Summary summary();

 private:
  struct Input {
    std::string name;
    Loss loss;
    double start;
    InputWatch watch;
  };
  struct Remark {
    std::string message;
    double until;
  };

  void enter(uint8_t level, const std::string& message);
  void report(diagnostic_updater::DiagnosticStatusWrapper& status);
  Summary summaryNow(double now);
  InputWatch::Silence silenceOf(const Input& input, double now) const;
  /// Of the inputs with this loss; level OK: none is silent.
  Summary silenceOf(Loss loss, double now) const;
  Summary ownState(double now) const;

  std::string stage_;
  diagnostic_updater::Updater updater_;
  std::mutex mutex_;
  uint8_t level_;
  std::string message_ = "starting";
  std::string last_problem_ = "none";
  std::map<std::string, uint64_t> counts_;
  std::vector<Input> inputs_;
  std::deque<Remark> remarks_;
  InputWatch results_;
  LatencyMeter latencies_;
  ros::WallTimer timer_;
  CallbackGate gate_;
};

}  // namespace markerless_mocap
