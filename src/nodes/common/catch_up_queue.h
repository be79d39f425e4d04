#pragma once

#include <condition_variable>
#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace markerless_mocap {

/// Queue between producers and one worker. Up to `max_size` items wait, so that a single slow item
/// causes no loss. If there are more, only the newest is kept until the queue is empty. A worker
/// that is too slow then processes items at even intervals and with little delay.
template <class Item>
class CatchUpQueue {
 public:
  explicit CatchUpQueue(size_t max_size) : max_size_(max_size) {}

  void push(Item item) {
    const std::lock_guard<std::mutex> lock(mutex_);
    waiting_.push_back(std::move(item));
    behind_ = behind_ || waiting_.size() > max_size_;
    if (behind_) dropAllButNewest();
    changed_.notify_one();
  }

  /// Waits for an item; returns nothing once the queue is closed.
  std::optional<Item> take() {
    std::unique_lock<std::mutex> lock(mutex_);
    if (waiting_.empty()) behind_ = false;
    changed_.wait(lock, [&] { return closed_ || !waiting_.empty(); });
    if (closed_) return std::nullopt;
    Item item = std::move(waiting_.front());
    waiting_.pop_front();
    return item;
  }

  /// While a long item is processed: drops items amid others that are near enough to each other, so
  /// that few wait, but without a large gap between two of them. The newest ones stay.
  /// \param near_enough whether none is needed between two items, bool(const Item&, const Item&)
  template <class NearEnough>
  void thinOut(size_t newest, const NearEnough& near_enough) {
    const std::lock_guard<std::mutex> lock(mutex_);
    for (size_t i = 1; i + newest < waiting_.size();) {
      if (!near_enough(waiting_[i - 1], waiting_[i + 1])) {
        ++i;
        continue;
      }
      waiting_.erase(waiting_.begin() + long(i));
      ++dropped_;
    }
  }

  void close() {
    const std::lock_guard<std::mutex> lock(mutex_);
    closed_ = true;
    changed_.notify_one();
  }

  /// Number of items that wait.
  size_t waitingCount() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return waiting_.size();
  }

  /// Number of items that were dropped for newer ones.
  uint64_t droppedCount() const {
    const std::lock_guard<std::mutex> lock(mutex_);
    return dropped_;
  }

 private:
  void dropAllButNewest() {
    dropped_ += waiting_.size() - 1;
    waiting_.erase(waiting_.begin(), std::prev(waiting_.end()));
  }

  const size_t max_size_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<Item> waiting_;
  bool behind_ = false, closed_ = false;
  uint64_t dropped_ = 0;
};

}  // namespace markerless_mocap
