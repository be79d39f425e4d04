#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace markerless_mocap {

/// Quantiles of recent durations (about ten seconds at 30 frames per second).
class LatencyMeter {
 public:
  void add(double seconds) {
    if (last_.size() < kKept)
      last_.push_back(seconds);
    else
      last_[next_++ % kKept] = seconds;
  }
  /// Quantile in milliseconds; 0 without data. \param fraction 0.5 for the median
  uint64_t milliseconds(double fraction) const {
    if (last_.empty()) return 0;
    std::vector<double> sorted = last_;
    const auto at = sorted.begin() + std::ptrdiff_t(fraction * double(sorted.size() - 1));
    std::nth_element(sorted.begin(), at, sorted.end());
    return uint64_t(std::max(0.0, 1e3 * *at + 0.5));
  }

 private:
  static constexpr size_t kKept = 300;
  std::vector<double> last_;
  size_t next_ = 0;
};

}  // namespace markerless_mocap
