#pragma once

#include <deque>
#include <utility>

namespace markerless_mocap {

/// Frame sets in the order of time. A frame set for which messages may still arrive waits, and so
/// do those behind it, until they have arrived or too many frame sets wait.
template <class FrameSetT>
class HoldingQueue {
 public:
  explicit HoldingQueue(size_t max_waiting) : max_waiting_(max_waiting) {}

  void push(FrameSetT frame_set) { waiting_.push_back(std::move(frame_set)); }
  void clear() { waiting_.clear(); }

  /// Passes on the frame sets that need not wait, oldest first.
  template <class MustWaitT, class SinkT>
  void release(const MustWaitT& must_wait, const SinkT& sink) {
    while (!waiting_.empty() && (waiting_.size() > max_waiting_ || !must_wait(waiting_.front()))) {
      FrameSetT frame_set = std::move(waiting_.front());
      waiting_.pop_front();
      sink(std::move(frame_set));
    }
  }

 private:
  size_t max_waiting_;
  std::deque<FrameSetT> waiting_;
};

}  // namespace markerless_mocap
