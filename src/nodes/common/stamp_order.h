#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "nodes/common/usual_delay.h"

namespace markerless_mocap {

/// Judges the stamps of one camera, whose images come in the order of time. What is against that
/// order is first left out; a second stamp that continues it tells that the clock was set.
class StampOrder {
 public:
  enum class Verdict {
    kInOrder,
    kZero,       ///< the stamp was never set
    kDuplicate,  ///< as the last one, or so near that no camera can have sent both
    kDoubtful,   ///< behind the last one, or too far ahead for the time that has passed
    kStepped,    ///< in order, but the clock was set before it
  };
  struct Judgement {
    Verdict verdict = Verdict::kInOrder;
    double step = 0.0;  ///< s, by how much the clock was set; 0 unless kStepped
    /// Whether the image is to be used.
    bool isUsable() const { return verdict == Verdict::kInOrder || verdict == Verdict::kStepped; }
  };

  /// \param arrival_ns by a clock that is never set
  Judgement judge(int64_t stamp_ns, int64_t arrival_ns);
  /// How many duplicates have come since the last stamp that was none.
  int duplicates() const { return duplicates_; }

 private:
  Judgement judged(int64_t stamp_ns, int64_t arrival_ns);
  bool continues(int64_t from_ns, int64_t stamp_ns, int64_t passed_ns) const;
  Judgement accept(int64_t stamp_ns, int64_t arrival_ns, Judgement judgement);

  struct Arrival {
    int64_t stamp_ns, arrival_ns;
  };
  static constexpr int64_t kNearest = 100'000;   // ns
  static constexpr double kFirstPeriod = 125e6;  // ns, until the period is known
  static constexpr double kMissedImages = 4.0;   // so many may lack between two stamps
  static constexpr double kFastest = 3.0;        // a bag may be played this much faster
  static constexpr double kShare = 0.1;          // of the newest difference in the period

  std::optional<Arrival> last_;
  std::optional<Arrival> doubtful_;  ///< the last one that was left out
  UsualDelay delay_;
  double period_ns_ = 0.0;  ///< between images in order; 0: not known yet
  int duplicates_ = 0;      ///< in a row
};

inline bool StampOrder::continues(int64_t from_ns, int64_t stamp_ns, int64_t passed_ns) const {
  const double period = period_ns_ > 0.0 ? period_ns_ : kFirstPeriod;
  return stamp_ns > from_ns &&
         double(stamp_ns - from_ns) <= kMissedImages * period + kFastest * double(passed_ns);
}

inline StampOrder::Judgement StampOrder::accept(int64_t stamp_ns, int64_t arrival_ns,
                                                Judgement judgement) {
  if (judgement.verdict == Verdict::kStepped) delay_.forget();
  delay_.add(stamp_ns, arrival_ns);
  last_ = {stamp_ns, arrival_ns};
  doubtful_.reset();
  return judgement;
}

inline StampOrder::Judgement StampOrder::judge(int64_t stamp_ns, int64_t arrival_ns) {
  const Judgement judgement = judged(stamp_ns, arrival_ns);
  duplicates_ = judgement.verdict == Verdict::kDuplicate ? duplicates_ + 1 : 0;
  return judgement;
}

inline StampOrder::Judgement StampOrder::judged(int64_t stamp_ns, int64_t arrival_ns) {
  if (stamp_ns == 0) return {Verdict::kZero};
  if (!last_) return accept(stamp_ns, arrival_ns, {});
  if (std::abs(stamp_ns - last_->stamp_ns) < kNearest) return {Verdict::kDuplicate};
  const bool catches_up =
      stamp_ns > last_->stamp_ns && delay_.isUsual(stamp_ns, arrival_ns, int64_t(period_ns_));
  if (catches_up || continues(last_->stamp_ns, stamp_ns, arrival_ns - last_->arrival_ns)) {
    const double difference = double(stamp_ns - last_->stamp_ns);
    if (period_ns_ > 0.0)  // a pause tells no period
      period_ns_ += kShare * (std::min(difference, kMissedImages * period_ns_) - period_ns_);
    else
      period_ns_ = difference;
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
