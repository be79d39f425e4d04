#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <utility>

#include "nodes/silhouette/per_frame_set.h"

namespace markerless_mocap {

/// Settings that all cameras change at the same capture time, though each works at its own pace: no
/// frame set has masks of old and new settings. Thread-safe.
template <class SettingsT>
class TimedSettings {
 public:
  using Pointer = std::shared_ptr<const SettingsT>;

  TimedSettings(size_t cameras, SettingsT settings)
      : newest_(std::make_shared<const SettingsT>(std::move(settings))), settings_(cameras) {}

  /// The settings for an image; to be called for every image, before it is processed.
  Pointer at(size_t camera, int64_t stamp_ns) {
    const std::lock_guard<std::mutex> lock(mutex_);
    return settings_.at(camera, stamp_ns, [this] { return newest_; });
  }

  /// Changes the settings from the next frame set on that no camera has begun.
  void change(SettingsT settings) {
    const std::lock_guard<std::mutex> lock(mutex_);
    newest_ = std::make_shared<const SettingsT>(std::move(settings));
  }

 private:
  std::mutex mutex_;
  Pointer newest_;
  PerFrameSet<Pointer> settings_;
};

}  // namespace markerless_mocap
