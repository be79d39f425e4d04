#pragma once

#include <algorithm>
#include <string>

namespace markerless_mocap {

/// Whose messages of one topic are used. Those of two nodes contradict each other, so only the one
/// counts that sent first, until it has been silent for a while. Times in seconds of a clock that
/// is never set.
class SenderWatch {
 public:
  /// Whether a message is to be used.
  bool accept(const std::string& sender, double now) {
    if (sender == sender_) {
      period_ += kShare * (std::min(now - last_, kLongest) - period_);
      last_ = now;
      return true;
    }
    if (!sender_.empty() && now - last_ < std::clamp(3.0 * period_, kSilence, kLongest))
      return false;
    if (first_.empty()) first_ = sender;
    sender_ = sender;
    last_ = now;
    period_ = 0.0;
    return true;
  }
  /// The node whose messages are used.
  const std::string& sender() const { return sender_; }
  /// The node that sent first of all.
  const std::string& firstSender() const { return first_; }

 private:
  static constexpr double kSilence = 0.5, kLongest = 3.0;  // s
  static constexpr double kShare = 0.2;                    // of the newest gap in the period

  std::string first_, sender_;
  double last_ = 0.0, period_ = 0.0;  ///< s
};

}  // namespace markerless_mocap
