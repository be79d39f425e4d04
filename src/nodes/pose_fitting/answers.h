#pragma once

#include <std_msgs/Header.h>

#include <algorithm>
#include <deque>
#include <optional>

namespace markerless_mocap {

/// The frame sets for which no pose has been published. Each is answered once, in order.
class Answers {
 public:
  void await(const std_msgs::Header& header) { waiting_.push_back(header); }
  /// Takes the oldest frame set if more than this many wait.
  std::optional<std_msgs::Header> takeLate(size_t allowed) {
    if (waiting_.size() <= allowed) return std::nullopt;
    const std_msgs::Header oldest = waiting_.front();
    waiting_.pop_front();
    return oldest;
  }
  /// Takes this frame set, and drops those before it. Returns false if it has been answered.
  bool take(const std_msgs::Header& header) {
    const auto at = std::find_if(waiting_.begin(), waiting_.end(),
                                 [&](const auto& one) { return one.stamp == header.stamp; });
    if (at == waiting_.end()) return false;
    waiting_.erase(waiting_.begin(), std::next(at));
    return true;
  }

 private:
  std::deque<std_msgs::Header> waiting_;
};

}  // namespace markerless_mocap
