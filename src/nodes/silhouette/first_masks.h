#pragma once

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <vector>

#include "nodes/silhouette/timed_settings.h"

namespace markerless_mocap {

/// What a camera does with its images.
enum class CameraPhase {
  kCollecting,  ///< images to learn the background from
  kLearning,    ///< it has them all
  kReady        ///< there are masks
};

/// Lets cameras that learn their backgrounds at the same time begin with the same frame set.
/// Whoever joins masks would wait for those of the others, and the frame sets behind would be late,
/// too. Thread-safe.
class FirstMasks {
 public:
  explicit FirstMasks(size_t cameras) : cameras_(cameras), may_begin_(cameras, true) {}

  /// Whether the mask of this image may be published. To be called for every image. \param now_s
  /// time of a steady clock, s
  bool mayPublish(size_t camera, int64_t stamp_ns, CameraPhase phase, double now_s) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const bool may_begin = *may_begin_.at(camera, stamp_ns);
    Camera& own = cameras_.at(camera);
    own.phase = phase;
    own.last_image_s = now_s;
    own.publishes = phase == CameraPhase::kReady && (own.publishes || may_begin);
    followLearning(now_s);
    return own.publishes;
  }

 private:
  struct Camera {
    CameraPhase phase = CameraPhase::kCollecting;
    double last_image_s = 0.0;
    bool publishes = false;
  };
  static constexpr double kSilence = 0.5;  // s; nobody waits for a camera that has stopped

  void followLearning(double now_s) {
    const bool any_learns = std::any_of(cameras_.begin(), cameras_.end(), [&](const Camera& one) {
      return one.phase == CameraPhase::kLearning && now_s - one.last_image_s < kSilence;
    });
    if (any_learns == any_learns_) return;
    any_learns_ = any_learns;
    may_begin_.change(!any_learns);
  }

  std::mutex mutex_;
  std::vector<Camera> cameras_;
  bool any_learns_ = false;
  TimedSettings<bool> may_begin_;
};

}  // namespace markerless_mocap
