#pragma once

#include <algorithm>
#include <optional>

namespace markerless_mocap {

/// When messages of one topic come. Times in seconds of a clock that is never set.
class InputWatch {
 public:
  enum class Silence { kNone, kSome, kLong };

  void arrived(double now) {
    if (last_) {
      const double gap = now - *last_;
      // Those of a burst, or after a long silence, do not tell the period.
      if (silence(now) != Silence::kLong) period_ += (count_ > 1 ? 0.1 : 1.0) * (gap - period_);
      ++count_;
    } else {
      count_ = 1;
    }
    last_ = now;
  }
  /// After 3 periods kSome, after 10 kLong, but not within half a second and a second.
  Silence silence(double now) const {
    if (count_ < 2) return Silence::kNone;
    const double since = now - *last_;
    if (since > std::max(10 * period_, kLong)) return Silence::kLong;
    return since > std::max(3 * period_, kSome) ? Silence::kSome : Silence::kNone;
  }
  /// Time of the last message, if there was one.
  std::optional<double> last() const { return last_; }

 private:
  static constexpr double kSome = 0.5, kLong = 1.0;
  std::optional<double> last_;
  double period_ = 0.0;
  int count_ = 0;
};

}  // namespace markerless_mocap
