#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <vector>

#include "numerics/order_statistics.h"

namespace markerless_mocap {

/// Quantiles of the durations of the last ten seconds.
class LatencyMeter {
 public:
  /// \param now time of a steady clock, s \param duration s
  void add(double now, double duration) {
    last_.push_back({now, duration});
    forget(now);
  }
  void forget(double now) {
    while (!last_.empty() && last_.front().time < now - kSpan) last_.pop_front();
  }
  bool empty() const { return last_.empty(); }
  /// Quantile in milliseconds; 0 without data. \param fraction 0.5 for the median
  uint64_t milliseconds(double fraction) const {
    if (last_.empty()) return 0;
    std::vector<double> durations;
    for (const Entry& entry : last_) durations.push_back(entry.duration);
    return uint64_t(std::max(0.0, 1e3 * quantileAmong(durations, fraction) + 0.5));
  }

 private:
  struct Entry {
    double time, duration;
  };

  static constexpr double kSpan = 10;  // s
  std::deque<Entry> last_;
};

}  // namespace markerless_mocap
