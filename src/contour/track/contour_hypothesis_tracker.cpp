#include "contour/track/contour_hypothesis_tracker.h"

#include <array>
#include <utility>

namespace markerless_mocap {
namespace {

// With a smaller overlap, the person is lost.
constexpr double kLostOverlap = 0.65;

constexpr int64_t kSuspiciousInterval_ns = 150000000;  // after a search without success
constexpr int64_t kLeastCertainInterval_ns = 500000000;
constexpr int64_t kUntwistInterval_ns = 60000000;

constexpr std::array kSearchedLimbs{ContourLimb::kLeftArm, ContourLimb::kRightArm,
                                    ContourLimb::kLeftLeg, ContourLimb::kRightLeg};

}  // namespace

const char* toString(ContourTrackingStatus status) {
  constexpr const char* kNames[] = {"lost", "tracked", "limb recovered", "limb lost"};
  return kNames[size_t(status)];
}

ContourHypothesisTracker::ContourHypothesisTracker(const CameraRig& rig,
                                                   const ContourOptions& options)
    : rivals_(rig, options),
      suspicious_(kSuspiciousInterval_ns),
      least_certain_(kLeastCertainInterval_ns),
      untwist_(kUntwistInterval_ns) {}

void ContourHypothesisTracker::searchSoon() {
  suspicious_.dueNow();
  least_certain_.dueNow();
}

ContourTrackingResult ContourHypothesisTracker::keep(int64_t stamp_ns, const ContourFit& fit,
                                                     ContourTrackingStatus status) {
  if (fit.status != ContourFitStatus::kFitted || fit.overlap < kLostOverlap) {
    history_.forget();
    return {ContourTrackingStatus::kLost, fit};
  }
  history_.add(stamp_ns, fit);
  return {status, fit};
}

ContourTrackingResult ContourHypothesisTracker::start(int64_t stamp_ns,
                                                      const ContourObservation& seen,
                                                      const ContourBody& body,
                                                      const ContourPose& pose) {
  return startFrom(stamp_ns, search(seen, body, pose));
}

ContourTrackingResult ContourHypothesisTracker::startFrom(int64_t stamp_ns, const ContourFit& fit) {
  lose();
  suspicious_.dueAt(stamp_ns);
  least_certain_.done(stamp_ns);  // a start searches all limbs
  untwist_.dueAt(stamp_ns);
  return keep(stamp_ns, fit, ContourTrackingStatus::kTracked);
}

ContourTrackingStatus ContourHypothesisTracker::repair(int64_t stamp_ns, const FittedFrame& now,
                                                       const ContourPrediction& prediction,
                                                       const MaySearch& may_search,
                                                       ContourFit* fit) {
  bool better = false;
  if (suspicious_.isDue(stamp_ns)) {
    better = rivals_.tryLastPose(now, history_, prediction, fit);
    better = searchSuspiciousLimbs(stamp_ns, now, prediction, may_search, better, fit);
  }
  if (any(history_.suspicious(*fit))) return ContourTrackingStatus::kLimbLost;
  return better ? ContourTrackingStatus::kLimbRecovered : ContourTrackingStatus::kTracked;
}

// One limb after the other while there is time, until none is suspicious. What is left then is
// searched in the next frame.
bool ContourHypothesisTracker::searchSuspiciousLimbs(int64_t stamp_ns, const FittedFrame& now,
                                                     const ContourPrediction& prediction,
                                                     const MaySearch& may_search, bool better,
                                                     ContourFit* fit) {
  for (; next_limb_ < kSearchedLimbs.size(); ++next_limb_) {
    const LimbFlags suspicious = history_.suspicious(*fit);
    if (better && !any(suspicious)) break;
    const ContourLimb::Id limb = kSearchedLimbs[next_limb_];
    if (!suspicious[limb]) continue;
    if (may_search && !may_search()) return better;
    better |= rivals_.searchLimbNear(now, limb, prediction, fit);
  }
  next_limb_ = 0;
  if (!better) suspicious_.done(stamp_ns);
  return better;
}

std::optional<ContourFit> ContourHypothesisTracker::improve(const ContourObservation& seen,
                                                            const ContourBody& body) {
  if (!updated_) return std::nullopt;
  const auto [stamp_ns, before, prediction, fitted] = *std::exchange(updated_, std::nullopt);
  const FittedFrame now{seen, body};
  ContourFit fit = fitted;
  bool better = false;
  if (least_certain_.isDue(stamp_ns)) {
    least_certain_.done(stamp_ns);
    better = rivals_.searchLeastCertainLimb(now, prediction, &fit);
  }
  if (untwist_.isDue(stamp_ns)) {
    untwist_.done(stamp_ns);
    better |= rivals_.untwist(now, prediction, &fit);
  }
  if (!better) return std::nullopt;
  history_ = before;
  history_.add(stamp_ns, fit);
  return fit;
}

ContourTrackingResult ContourHypothesisTracker::update(int64_t stamp_ns,
                                                       const ContourObservation& seen,
                                                       const ContourBody& body,
                                                       const MaySearch& may_search) {
  const std::optional<ContourPrediction> predicted = predict(stamp_ns);
  updated_.reset();
  if (!predicted) {
    history_.forget();
    return {};
  }
  const FittedFrame now{seen, body};
  ContourFit fit =
      fitter().fit(seen, body, predicted->pose, predicted, fitter().schedule(predicted->seconds));
  ContourTrackingStatus status = ContourTrackingStatus::kTracked;
  if (fit.status == ContourFitStatus::kFitted) {
    if (any(history_.suspicious(fit)))
      status = repair(stamp_ns, now, *predicted, may_search, &fit);
    else
      next_limb_ = 0;
  }
  Updated updated{stamp_ns, history_, *predicted, fit};
  const ContourTrackingResult result = keep(stamp_ns, fit, status);
  if (result.status != ContourTrackingStatus::kLost) updated_ = std::move(updated);
  return result;
}

}  // namespace markerless_mocap
