#include "nodes/common/stamp_order.h"

#include <cmath>

namespace markerless_mocap {
namespace {

constexpr double kFirstPeriod = 125e6;  // ns, until the period is known
constexpr double kMissedImages = 4.0;   // so many may lack between two stamps
constexpr double kFastest = 3.0;        // a bag may be played this much faster
constexpr double kShare = 0.1;          // of the newest difference in the period

}  // namespace

bool StampOrder::continues(int64_t from_ns, int64_t stamp_ns, int64_t passed_ns) const {
  const double period = period_ns_ > 0.0 ? period_ns_ : kFirstPeriod;
  return stamp_ns > from_ns &&
         double(stamp_ns - from_ns) <= kMissedImages * period + kFastest * double(passed_ns);
}

StampOrder::Judgement StampOrder::accept(int64_t stamp_ns, int64_t arrival_ns,
                                         Judgement judgement) {
  last_ = {stamp_ns, arrival_ns};
  doubtful_.reset();
  return judgement;
}

StampOrder::Judgement StampOrder::judge(int64_t stamp_ns, int64_t arrival_ns) {
  if (stamp_ns == 0) return {Verdict::kZero};
  if (!last_) return accept(stamp_ns, arrival_ns, {});
  if (stamp_ns == last_->stamp_ns) return {Verdict::kDuplicate};
  if (continues(last_->stamp_ns, stamp_ns, arrival_ns - last_->arrival_ns)) {
    const double difference = double(stamp_ns - last_->stamp_ns);
    period_ns_ += (period_ns_ > 0.0 ? kShare : 1.0) * (difference - period_ns_);
    return accept(stamp_ns, arrival_ns, {});
  }
  if (doubtful_ && continues(doubtful_->stamp_ns, stamp_ns, arrival_ns - doubtful_->arrival_ns)) {
    const double passed = double(arrival_ns - last_->arrival_ns);
    const double step = 1e-9 * (double(stamp_ns - last_->stamp_ns) - passed);
    return accept(stamp_ns, arrival_ns, {Verdict::kStepped, step});
  }
  doubtful_ = {stamp_ns, arrival_ns};
  return {Verdict::kDoubtful};
}

}  // namespace markerless_mocap
