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

}  // namespace markerless_mocap
