#include "contour/track/start_schedule.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

// After a search the next one waits for this fraction of the time since the first, up to the last
// value.
constexpr double kRest = 0.2;
constexpr int64_t kLongestRest_ns = 400000000;
constexpr int64_t kCheckInterval_ns = 50000000;

// A search by colour takes longer. Of seventeen starts on the beam film five had a wrong arm or
// exchanged legs; later searches found the right pose, with a higher score. So each start is
// checked by a search, and again after twice this time, then four times and eight times this.
constexpr int64_t kColorCheckInterval_ns = 100000000;
constexpr int kColorChecks = 4;         // at most
constexpr int kColorConfirmations = 2;  // in a row are enough

}  // namespace

int64_t StartSchedule::restAfterSearch(int64_t stamp_ns, int64_t least_ns) const {
  const double since = double(stamp_ns - searching_since_ns_.value_or(stamp_ns));
  return std::max(least_ns, std::min(int64_t(kRest * since), kLongestRest_ns));
}

void StartSchedule::startBegins(int64_t stamp_ns, bool by_color) {
  searchBegins(stamp_ns);
  next_start_ns_ = stamp_ns + restAfterSearch(stamp_ns, by_color ? 2 * kColorCheckInterval_ns : 0);
  next_check_ns_ = stamp_ns + kCheckInterval_ns;
  color_checks_ = color_confirmations_ = 0;
}

void StartSchedule::noteHull(int64_t stamp_ns, bool somebody_there) {
  if (somebody_there && !somebody_there_) searching_since_ns_ = stamp_ns;
  somebody_there_ = somebody_there;
}

void StartSchedule::checkBegins(int64_t stamp_ns) {
  next_check_ns_ = stamp_ns + restAfterSearch(stamp_ns, kCheckInterval_ns);
}

void StartSchedule::colorCheckBegins(int64_t stamp_ns) {
  next_check_ns_ = stamp_ns + (kColorCheckInterval_ns << std::min(++color_checks_, kColorChecks));
}

void StartSchedule::contradict(int64_t stamp_ns) {
  color_confirmations_ = 0;
  next_check_ns_ = stamp_ns + restAfterSearch(stamp_ns, 2 * kColorCheckInterval_ns);
}

bool StartSchedule::wantsColorChecks() const {
  return color_checks_ < kColorChecks && color_confirmations_ < kColorConfirmations;
}

}  // namespace markerless_mocap
