#pragma once

#include <cstdint>
#include <mutex>

#include "nodes/silhouette/per_frame_set.h"

namespace markerless_mocap {

/// Leaves frame sets out where images come faster than they can be processed: otherwise each would
/// wait for as long as the queue is. Short peaks are waited out. Once images have waited for long,
/// only frame sets are let in whose first image has waited little. All cameras leave out the same
/// ones, so that none lacks in those that are processed. Thread-safe.
class LoadShedding {
 public:
  explicit LoadShedding(size_t cameras) : admitted_(cameras) {}

  /// Whether an image is to be processed; to be called for every image.
  /// \param waited_s since it was received
  /// \param now_s time of a steady clock, s
  bool admits(size_t camera, int64_t stamp_ns, double waited_s, double now_s) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return admitted_.at(camera, stamp_ns, [&] { return admitsNext(waited_s, now_s); });
  }

 private:
  static constexpr double kLatest = 0.15;  // s; longer waits are no peak, but an overload,
  static constexpr double kCalm = 0.5;     // s; which is over after as long without them
  static constexpr double kLittle = 0.05;  // s; the longest wait meanwhile

  bool admitsNext(double waited_s, double now_s) {
    if (waited_s > kLatest) overload_until_s_ = now_s + kCalm;
    return waited_s < kLittle || now_s > overload_until_s_;
  }

  std::mutex mutex_;
  PerFrameSet<bool> admitted_;
  double overload_until_s_ = 0.0;
};

}  // namespace markerless_mocap
