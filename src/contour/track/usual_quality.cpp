#include "contour/track/usual_quality.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

constexpr int kFew = 10;
constexpr double kRate = 0.03;  // of the smoothing, per frame
constexpr double kMaxDeviations = 2.5;
// Of qualities that hardly vary.
constexpr double kMinDeviation = 0.002;

// Silhouettes that are coarser than usual for a while lower it by less.
constexpr double kNear = 0.025;

// What is lower by more is of another kind: masks that do not show the person, or a body beside
// them. Where two of four cameras are covered or blurred it is lower by 0.4 and more; of coarse
// masks of all cameras, after a background was spoilt, by 0.12.
constexpr double kFar = 0.13, kFarDeviations = 6.0;
// A person may have put on a coat, and fits worse from now on.
constexpr int64_t kPatience_ns = 10000000000;

}  // namespace

void UsualQuality::add(double quality) {
  const double rate = std::max(kRate, 1.0 / double(++count_));
  const double difference = quality - mean_;
  mean_ += rate * difference;
  if (count_ > 1) variance_ = (1.0 - rate) * (variance_ + rate * difference * difference);
}

bool UsualQuality::includes(double quality) const {
  if (count_ < kFew) return true;
  return quality > mean_ - kMaxDeviations * std::max(kMinDeviation, std::sqrt(variance_));
}

bool UsualQuality::isNear(double quality) const {
  return includes(quality + kNear);
}

bool UsualQuality::isFarAbove(int64_t stamp_ns, double quality) {
  const double deviation = std::sqrt(variance_);
  if (count_ < kFew || quality > mean_ - std::max(kFar, kFarDeviations * deviation)) {
    far_above_since_ns_.reset();
    return false;
  }
  if (!far_above_since_ns_) far_above_since_ns_ = stamp_ns;
  if (stamp_ns - *far_above_since_ns_ < kPatience_ns) return true;
  forget();
  return false;
}

}  // namespace markerless_mocap
