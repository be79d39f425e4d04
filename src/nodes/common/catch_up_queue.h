#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace markerless_mocap {

/// Passes items from those who bring them to one who works on them. A single slow item delays those
/// behind it; once more than `most` wait, only the newest is worked on until none is left behind,
/// so that a worker who is too slow takes even steps and stays near the present.
template <class Item>
class CatchUpQueue {
 public:
  explicit CatchUpQueue(size_t most) : max_size_(most) {}

  void push(Item item) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(std::move(item));
    behind_ = behind_ || waiting_.size() > max_size_;
    if (behind_) dropAllButNewest();
    changed_.notify_one();
  }

  /// Waits for an item; nothing once the queue is closed.
  std::optional<Item> take() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (waiting_.empty()) behind_ = false;
    changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    if (closed_) return std::nullopt;
    Item item = std::move(waiting_.front());
    waiting_.pop_front();
    return item;
  }

  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    changed_.notify_one();
  }

  /// Items that were not worked on for newer ones.
  uint64_t droppedCount() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return passed_over_;
  }

 private:
  void dropAllButNewest() {
    passed_over_ += waiting_.size() - 1;
    waiting_.erase(waiting_.begin(), std::prev(waiting_.end()));
  }

  const size_t max_size_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> waiting_;
  bool behind_ = false, closed_ = false;
  uint64_t passed_over_ = 0;
};

}  // namespace markerless_mocap
