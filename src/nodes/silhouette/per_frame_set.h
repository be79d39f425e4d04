#pragma once

#include <algorithm>
#include <cstdint>
#include <deque>
#include <iterator>
#include <utility>
#include <vector>

namespace markerless_mocap {

/// A value for each frame set, the same for all cameras though each works at its own pace. The
/// stamps of a frame set may differ by less than half a period; cameras out of step are told apart
/// while they take turns.
template <class ValueT>
class PerFrameSet {
 public:
  explicit PerFrameSet(size_t cameras) : cameras_(cameras) {}

  /// The value of an image's frame set; to be called for every image.
  /// \param choose returns the value of a frame set that no camera has begun before
  template <class ChooseT>
  ValueT at(size_t camera, int64_t stamp_ns, const ChooseT& choose) {
    if (stamp_ns < newest_ns_ - kJump) beginAnew();  // the clock was set, or a bag begins again
    Camera& own = cameras_.at(camera);
    const int64_t passed_ns = own.last_ns == kNever ? 0 : stamp_ns - own.last_ns;
    if (period_ns_ == 0) period_ns_ = std::max<int64_t>(passed_ns, 0);
    if (sets_.empty() || beginsNext(own, stamp_ns)) begin(stamp_ns, choose());
    if (passed_ns > 0) period_ns_ = passed_ns;  // only now: it may have lost images
    const auto later = std::find_if(sets_.begin() + 1, sets_.end(),
                                    [&](const Set& set) { return set.from_ns > stamp_ns; });
    const Set& set = *std::prev(later);
    own = {stamp_ns, set.number};
    newest_ns_ = std::max(newest_ns_, stamp_ns);
    return set.value;
  }

 private:
  struct Set {
    uint64_t number;
    int64_t from_ns, first_ns;  ///< where it begins, and the stamp of its first image
    ValueT value;
  };
  struct Camera {
    int64_t last_ns = kNever;
    uint64_t set = 0;  ///< that of its last image
  };
  static constexpr int64_t kNever = INT64_MIN / 2;  ///< differences do not overflow
  static constexpr int64_t kJump = 2'000'000'000;   // ns; cameras lag by less
  static constexpr size_t kKept = 64;

  /// Whether the camera has had its image of the newest set, or has lost it.
  bool beginsNext(const Camera& own, int64_t stamp_ns) const {
    const Set& newest = sets_.back();
    return (own.set == newest.number && stamp_ns > own.last_ns) ||
           (period_ns_ > 0 && stamp_ns > newest.first_ns + period_ns_ * 3 / 4);
  }
  void begin(int64_t stamp_ns, ValueT value) {
    const int64_t from_ns = sets_.empty() ? kNever : stamp_ns - period_ns_ / 2;
    sets_.push_back({++last_number_, from_ns, stamp_ns, std::move(value)});
    if (sets_.size() > kKept) sets_.pop_front();
  }
  void beginAnew() {
    sets_.clear();
    std::fill(cameras_.begin(), cameras_.end(), Camera());
    newest_ns_ = kNever;
  }

  std::vector<Camera> cameras_;
  int64_t newest_ns_ = kNever, period_ns_ = 0;
  uint64_t last_number_ = 0;
  std::deque<Set> sets_;  ///< in the order of time
};

}  // namespace markerless_mocap
