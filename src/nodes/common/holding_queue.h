#pragma once

#include <deque>
#include <utility>

namespace markerless_mocap {

/// Frame sets in the order of time. A frame set for which messages may still arrive is kept back,
/// and so are those behind it, until they have arrived or too many frame sets wait.
template <class FrameSetT>
class HoldingQueue {
 public:
  explicit HoldingQueue(size_t max_held) : max_held_(max_held) {}

  void push(FrameSetT frame_set) { held_.push_back(std::move(frame_set)); }
  void clear() { held_.clear(); }

  /// Passes on the frame sets that need not wait, oldest first.
  template <class MustWaitT, class SinkT>
  void release(const MustWaitT& must_wait, const SinkT& sink) {
    while (!held_.empty() && (held_.size() > max_held_ || !must_wait(held_.front()))) {
      FrameSetT frame_set = std::move(held_.front());
      held_.pop_front();
      sink(std::move(frame_set));
    }
  }

 private:
  size_t max_held_;
  std::deque<FrameSetT> held_;
};

}  // namespace markerless_mocap
