#pragma once

#include <cstdint>
#include <optional>

namespace markerless_mocap {

/// How long messages usually need from their stamp to their arrival, at least. Where stamps jump
/// ahead it tells messages that came late and catch up, as after a process has stood still, from
/// a clock that was set.
class UsualDelay {
 public:
  /// \param arrival_ns by a clock that is never set
  void add(int64_t stamp_ns, int64_t arrival_ns) {
    const double later_ns = double(arrival_ns - stamp_ns) - delay_ns_.value_or(0.0);
    delay_ns_ =
        delay_ns_.value_or(0.0) + (!delay_ns_ || later_ns < 0.0 ? later_ns : kDrift * later_ns);
  }
  /// The clock was set: what was usual before says nothing.
  void forget() { delay_ns_.reset(); }
  /// Whether the stamp is no further ahead than those that came without delay.
  bool isUsual(int64_t stamp_ns, int64_t arrival_ns, int64_t tolerance_ns) const {
    return delay_ns_ && double(arrival_ns - stamp_ns) >= *delay_ns_ - double(tolerance_ns);
  }

 private:
  static constexpr double kDrift = 1e-3;  // of a longer delay each message, as clocks drift

  std::optional<double> delay_ns_;
};

}  // namespace markerless_mocap
