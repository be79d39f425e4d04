#pragma once

#include <algorithm>
#include <boost/shared_ptr.hpp>
#include <cstdint>
#include <cstdlib>
#include <deque>
#include <optional>

namespace markerless_mocap {

/// The last messages of one topic. Times in seconds of a clock that is never set.
template <class MessageT>
class RecentMessages {
 public:
  using Ptr = boost::shared_ptr<const MessageT>;

  /// From now on messages are expected; what came before is forgotten.
  void expect(double now) {
    messages_.clear();
    expected_since_ = now;
    last_arrival_.reset();
  }
  /// A stamp that is not later than the last one discards the earlier messages: time went back.
  void add(int64_t stamp_ns, Ptr message, double now) {
    if (!messages_.empty() && stamp_ns <= messages_.back().stamp_ns) messages_.clear();
    messages_.push_back({stamp_ns, std::move(message)});
    if (messages_.size() > kKept) messages_.pop_front();
    if (last_arrival_) gap_ += kGapRate * (now - *last_arrival_ - gap_);
    last_arrival_ = now;
  }
  /// The message nearest to this time within the tolerance; null if there is none.
  Ptr at(int64_t stamp_ns, int64_t tolerance_ns) const {
    Ptr nearest;
    for (const Entry& entry : messages_)
      if (const int64_t distance = std::abs(entry.stamp_ns - stamp_ns); distance <= tolerance_ns) {
        nearest = entry.message;
        tolerance_ns = distance;
      }
    return nearest;
  }
  /// The last message, if it is not older than this compared with a time.
  Ptr newest(int64_t stamp_ns, int64_t max_age_ns) const {
    const bool fits =
        !messages_.empty() && std::abs(messages_.back().stamp_ns - stamp_ns) <= max_age_ns;
    return fits ? messages_.back().message : Ptr();
  }
  /// Whether the message of this time may still come.
  bool mayCome(int64_t stamp_ns, double now) const {
    if (!messages_.empty() && messages_.back().stamp_ns > stamp_ns) return false;
    return now < waitingEnds();
  }

 private:
  struct Entry {
    int64_t stamp_ns;
    Ptr message;
  };
  static constexpr size_t kKept = 64;
  static constexpr double kGapRate = 0.2;
  // s. A stage that is asked after a rest has to be connected first.
  static constexpr double kSilence = 0.3, kFirstSilence = 1.0, kLongest = 2.0;

  /// When a stage is taken for silent.
  double waitingEnds() const {
    if (!last_arrival_) return expected_since_ + kFirstSilence;
    return *last_arrival_ + std::clamp(3.0 * gap_, kSilence, kLongest);
  }

  std::deque<Entry> messages_;
  std::optional<double> last_arrival_;
  double expected_since_ = 0.0, gap_ = 0.0;
};

}  // namespace markerless_mocap
