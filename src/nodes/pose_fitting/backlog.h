#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>

namespace markerless_mocap {

/// Decides when a worker that is late does only what it must. Whatever may be put off is done while
/// nothing waits: a long search makes it late, then it catches up before the next one. Where the
/// least that it can do is too slow for that, it searches all the same now and then, while few
/// items wait.
class Backlog {
 public:
  /// \param few so many items may wait when it searches all the same
  explicit Backlog(size_t few) : few_(few) {}

  /// The next item is taken up.
  /// \param waiting items behind it
  /// \param now_s time of a steady clock, s
  void begin(size_t waiting, double now_s) {
    catching_up_s_ += std::min(now_s - last_begin_s_, kSearch_s);
    last_begin_s_ = now_s;
    if (waiting == 0) catching_up_s_ = 0.0;
    searches_all_the_same_ = waiting <= few_ && catching_up_s_ > kPatience_s;
    if (searches_all_the_same_) catching_up_s_ = 0.0;
  }
  /// Whether only what the item needs may be done now. \param waiting items behind it by now
  bool isBehind(size_t waiting) const { return waiting > 0 && !searches_all_the_same_; }

 private:
  static constexpr double kPatience_s = 2.0;
  static constexpr double kSearch_s = 0.2;  ///< as long counts an item that was searched for

  const size_t few_;
  std::atomic<bool> searches_all_the_same_{false};
  double last_begin_s_ = 0.0;
  /// Since nothing waited, or a search was allowed all the same.
  double catching_up_s_ = 0.0;
};

}  // namespace markerless_mocap
