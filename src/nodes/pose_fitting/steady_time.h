#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <optional>

#include "nodes/common/usual_delay.h"

namespace markerless_mocap {

/// Whether the later stamp is less than so long after the earlier one. It is not where the clock
/// was set back between them.
inline bool isWithin(int64_t longest_ns, int64_t earlier_ns, int64_t later_ns) {
  return later_ns >= earlier_ns && later_ns - earlier_ns < longest_ns;
}

/// The tracker's time of stamps, which goes on when the clock is set while the person is followed,
/// and when it stands still and the person does not: then as over a gap that makes a tracker doubt.
/// Only one thread may call at().
class SteadyTime {
 public:
  struct Moment {
    int64_t time_ns = 0;
    int64_t set_by_ns = 0;     ///< by how much the clock was set before it; 0: it was not
    bool after_pause = false;  ///< the time before is long ago, or has nothing to do with this one
  };

  /// \param arrival_ns by a clock that is never set
  Moment at(int64_t stamp_ns, int64_t arrival_ns);
  /// Of a stamp since the last moment. Thread-safe.
  int64_t timeOf(int64_t stamp_ns) const { return stamp_ns + shift_ns_; }

 private:
  /// How far the tracker's time goes on over a step of the clock; empty if it begins anew.
  std::optional<int64_t> acrossStep(int64_t ahead_ns, int64_t passed_ns) const;

  static constexpr int64_t kSmallStep = 2'000'000'000;  // ns, back
  static constexpr int64_t kPause = 500'000'000;        // ns, longer than between frame sets
  static constexpr int64_t kRealPause = 1'000'000'000;  // ns, a clock is set in less
  static constexpr int64_t kFastest = 8;                // a bag may be played this much faster
  // A bag that begins again is no step of the clock, but looks like one. A tracker doubts what it
  // sees after such a gap, and gives up after a longer one.
  static constexpr int64_t kDoubtedGap = 200'000'000, kLongestGap = 450'000'000;  // ns

  static constexpr double kUnusual = 5.0;  // so many times the usual time between arrivals
  static constexpr double kShare = 0.1;    // of the newest one in the usual one

  struct Last {
    int64_t stamp_ns, arrival_ns;
  };
  std::optional<Last> last_;
  UsualDelay delay_;
  int64_t period_ns_ = 0;         ///< between the last frame sets
  double usual_passed_ns_ = 0.0;  ///< between their arrivals; a bag may be played slowly
  std::atomic<int64_t> shift_ns_{0};
};

inline std::optional<int64_t> SteadyTime::acrossStep(int64_t ahead_ns, int64_t passed_ns) const {
  if (ahead_ns <= 0 && ahead_ns >= -kSmallStep) return period_ns_;
  if (passed_ns > kRealPause || (ahead_ns > 0 && ahead_ns < kFastest * passed_ns))
    return std::nullopt;
  return std::clamp(passed_ns, kDoubtedGap, kLongestGap);
}

inline SteadyTime::Moment SteadyTime::at(int64_t stamp_ns, int64_t arrival_ns) {
  const Last last = last_.value_or(Last{stamp_ns - 1, arrival_ns});
  last_ = {stamp_ns, arrival_ns};
  const bool usual = delay_.isUsual(stamp_ns, arrival_ns, period_ns_);
  const int64_t ahead_ns = stamp_ns - last.stamp_ns, passed_ns = arrival_ns - last.arrival_ns;
  const bool stood_still = passed_ns > std::max(double(kRealPause), kUnusual * usual_passed_ns_);
  usual_passed_ns_ += kShare * (double(passed_ns) - usual_passed_ns_);
  if (ahead_ns > 0 && ahead_ns < kPause) {
    period_ns_ = ahead_ns;
    delay_.add(stamp_ns, arrival_ns);
    if (stood_still) shift_ns_ += kLongestGap - ahead_ns;
    return {timeOf(stamp_ns)};
  }
  const std::optional<int64_t> gone_on_ns = acrossStep(ahead_ns, passed_ns);
  const bool catches_up =
      ahead_ns > 0 && usual;  // what came late, as after the process stood still
  if (!catches_up) delay_.forget();
  delay_.add(stamp_ns, arrival_ns);
  if (!gone_on_ns) {
    if (ahead_ns < 0) shift_ns_ = 0;
    return {timeOf(stamp_ns), 0, true};
  }
  shift_ns_ += *gone_on_ns - ahead_ns;
  return {timeOf(stamp_ns), catches_up ? 0 : ahead_ns - *gone_on_ns, false};
}

}  // namespace markerless_mocap
