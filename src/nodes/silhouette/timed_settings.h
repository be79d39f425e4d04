#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <iterator>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// Settings that all cameras change at the same capture time, though each works at its own pace: no
/// frame set has masks of old and new settings. Thread-safe.
template <class SettingsT>
class TimedSettings {
 public:
  using Pointer = std::shared_ptr<const SettingsT>;

  TimedSettings(size_t cameras, SettingsT settings)
      : last_ns_(cameras, kNever),
        changes_{{kNever, std::make_shared<const SettingsT>(std::move(settings))}} {}

  /// The settings for an image; to be called for every image, before it is processed.
  Pointer at(size_t camera, int64_t stamp_ns) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (newest_ns_ != kNever && stamp_ns < newest_ns_ - kJump) beginAnew();
    int64_t& last_ns = last_ns_.at(camera);
    if (last_ns != kNever && stamp_ns > last_ns) period_ns_ = stamp_ns - last_ns;
    last_ns = stamp_ns;
    newest_ns_ = std::max(newest_ns_, stamp_ns);
    const auto later = std::find_if(changes_.begin() + 1, changes_.end(),
                                    [&](const Change& c) { return c.from_ns > stamp_ns; });
    return std::prev(later)->settings;
  }

  /// Changes the settings from the next frame set on that no camera has begun. Half a period lies
  /// between them and the last image, as the stamps of a frame set may differ a little.
  void change(SettingsT settings) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const int64_t from_ns = newest_ns_ == kNever ? kNever : newest_ns_ + period_ns_ / 2 + 1;
    changes_.push_back({from_ns, std::make_shared<const SettingsT>(std::move(settings))});
    if (changes_.size() > kKept) changes_.pop_front();
  }

 private:
  struct Change {
    int64_t from_ns;
    Pointer settings;
  };
  static constexpr int64_t kNever = INT64_MIN;
  static constexpr int64_t kJump = 2'000'000'000;  // ns; cameras lag by less
  static constexpr size_t kKept = 64;

  /// The clock was set back, or a bag begins again.
  void beginAnew() {
    changes_ = {{kNever, changes_.back().settings}};
    std::fill(last_ns_.begin(), last_ns_.end(), kNever);
    newest_ns_ = kNever;
  }

  std::mutex mutex_;
  std::vector<int64_t> last_ns_;  ///< by camera
  int64_t newest_ns_ = kNever, period_ns_ = 0;
  std::deque<Change> changes_;  ///< in the order of time, never empty
};

}  // namespace markerless_mocap
