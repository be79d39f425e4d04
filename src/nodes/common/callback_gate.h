#pragma once

#include <memory>
#include <mutex>
#include <utility>

#include "nodes/common/end_process.h"

namespace markerless_mocap {

/// Keeps ROS callbacks out of an object that is being destroyed. At shutdown, ROS no longer removes
/// the callbacks of a subscription or timer from the threads that run them. The owner therefore has
/// to wait for a running callback and skip later ones. Declare the gate last in its owner, so that
/// it is destroyed first. Guarded callbacks run one at a time.
class CallbackGate {
 public:
  CallbackGate() = default;
  ~CallbackGate() { close(); }
  /// Waits for a running callback; none runs afterwards.
  void close() {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->open = false;
  }
  CallbackGate(const CallbackGate&) = delete;
  CallbackGate& operator=(const CallbackGate&) = delete;

  /// Wraps a callback; it is called only while the gate is open. An exception that it lets out ends
  /// the process with a sentence.
  template <class CallbackT>
  auto guarded(CallbackT callback) const {
    return [state = state_, callback = std::move(callback)](const auto&... arguments) {
      const std::lock_guard<std::mutex> lock(state->mutex);
      if (state->open) runOrEndProcess("a callback", [&] { callback(arguments...); });
    };
  }

 private:
  struct State {
    std::mutex mutex;
    bool open = true;
  };
  std::shared_ptr<State> state_ = std::make_shared<State>();
};

}  // namespace markerless_mocap
