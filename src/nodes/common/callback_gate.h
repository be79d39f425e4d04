#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace markerless_mocap {

/// Keeps ROS callbacks out of an object that ends. When ROS shuts down it no longer takes a
/// subscription's or timer's callbacks from the threads that run them, so the owner has to wait for
/// a running one and refuse those that follow. Declare it last in its owner: it closes first.
/// Guarded callbacks come one at a time.
class CallbackGate {
 public:
  CallbackGate() = default;
  ~CallbackGate() {
    const std::lock_guard<std::mutex> lock(state_->mutex);
    state_->open = false;
  }
  CallbackGate(const CallbackGate&) = delete;
  CallbackGate& operator=(const CallbackGate&) = delete;

  /// The callback, called only while the gate is open.
  template <class CallbackT>
  auto guarded(CallbackT callback) const {
    return [state = state_, callback = std::move(callback)](const auto&... arguments) {
      const std::lock_guard<std::mutex> lock(state->mutex);
      if (state->open) callback(arguments...);
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
