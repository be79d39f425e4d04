#include "contour/track/pose_history.h"

#include <algorithm>

namespace markerless_mocap {
namespace {

// Of the last velocity the prediction keeps this fraction.
constexpr double kVelocityFraction = 0.7;
constexpr int64_t kMaxGap_ns = 500000000;

// A quality below the usual value by more than kMaxDrop and kDeviationFactor usual deviations,
// which are larger with damaged masks, is suspicious. The usual value is smoothed with the rate
// kUsualRate.
constexpr double kMaxDrop = 0.015, kDeviationFactor = 1.5;
constexpr double kUsualRate = 0.1;

// A limb is suspicious if it lies outside the masks by more than this above the usual value, mean
// over its spheres. Damaged masks and clothes let correct limbs leave the masks, too.
constexpr double kLimbOutside = 0.025;  // metres

}  // namespace

bool any(const LimbFlags& limbs) {
  return std::any_of(limbs.begin(), limbs.end(), [](bool limb) { return limb; });
}

void PoseHistory::add(int64_t stamp_ns, const ContourFit& fit) {
  Past past{stamp_ns, fit.pose, std::nullopt, 0, qualityOf(fit), 0.0, {}};
  for (size_t i = 0; i < past.outside.size(); ++i) past.outside[i] = fit.limbs[i].outside;
  if (last_) {
    past.before = last_->pose;
    past.before_ns = last_->stamp_ns;
    // The usual quality rises at once and falls slowly, so that it does not adapt to a loss.
    const double quality_deviation = std::max(0.0, last_->quality - past.quality);
    past.quality = std::max(past.quality, last_->quality - kUsualRate * quality_deviation);
    past.quality_deviation =
        last_->quality_deviation + kUsualRate * (quality_deviation - last_->quality_deviation);
    for (size_t i = 0; i < past.outside.size(); ++i)
      past.outside[i] = std::min(
          past.outside[i], last_->outside[i] + kUsualRate * (past.outside[i] - last_->outside[i]));
  }
  last_ = past;
}

void PoseHistory::turnBack() {
  if (last_ && last_->before)
    last_->before = predictConstantVelocity(*last_->before, last_->pose, 1.0);
}

std::optional<ContourPrediction> PoseHistory::predict(int64_t stamp_ns) const {
  const int64_t gap = last_ ? stamp_ns - last_->stamp_ns : 0;
  if (!last_ || gap <= 0 || gap > kMaxGap_ns) return std::nullopt;
  return ContourPrediction{
      last_->before ? predictConstantVelocity(*last_->before, last_->pose, kVelocityFraction)
                    : last_->pose,
      1e-9 * double(gap)};
}

std::optional<ContourMotion> PoseHistory::motion(int64_t stamp_ns) const {
  const std::optional<ContourPrediction> predicted = predict(stamp_ns);
  if (!predicted || !last_->before) return std::nullopt;
  const double seconds = 1e-9 * double(last_->stamp_ns - last_->before_ns);
  return ContourMotion{predicted->pose, boxMinus(last_->pose, *last_->before) / seconds};
}

LimbFlags PoseHistory::suspicious(const ContourFit& fit) const {
  LimbFlags limbs{};
  const bool dropped =
      qualityOf(fit) < last_->quality - kMaxDrop - kDeviationFactor * last_->quality_deviation;
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i)
    limbs[i] = dropped || fit.limbs[i].outside > last_->outside[i] + kLimbOutside;
  return limbs;
}

}  // namespace markerless_mocap
