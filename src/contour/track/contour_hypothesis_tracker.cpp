#include "contour/track/contour_hypothesis_tracker.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "contour/fit/pose_priors.h"
#include "contour/track/exchanged_sides.h"
#include "contour/track/limb_search.h"
#include "contour/track/search_times.h"

namespace markerless_mocap {
namespace {

constexpr double kVelocityFraction =
    0.7;  // fraction of the last velocity that the prediction keeps
constexpr int64_t kMaxGap_ns = 500000000;

// With a smaller overlap, the person is lost.
constexpr double kLostOverlap = 0.65;

// Thresholds of the quality: a decrease by kMaxDrop below the usual value is suspicious; another
// pose replaces the current one if it is better by kMinGain. The usual value is smoothed with the
// rate kUsualRate.
constexpr double kMaxDrop = 0.015, kMinGain = 0.004;

// Where much of the contours is not the person's, a limb that explains some of them proves little.
// Another pose must be better by this much more for each ray beyond kUsuallyUnexplained (fractions
// of all rays) that the current one does not explain.
constexpr double kGainPerUnexplained = 0.15, kUsuallyUnexplained = 0.1;

// Another pose that explains more contours but covers the masks less by this much puts a limb where
// the contours of something else are.
constexpr double kMaxOverlapLoss = 0.005;
constexpr double kDeviationFactor = 1.5;  // times the usual deviation, which is larger with damaged
                                          // masks
constexpr double kUsualRate = 0.1;

constexpr int64_t kSearchInterval_ns = 150000000;  // after a search without success

// A limb is suspicious if it lies outside the masks by more than this above the usual value, mean
// over its spheres. Damaged masks and clothes let correct limbs leave the masks, too.
constexpr double kLimbOutside = 0.025;  // metres

// An arm that was lost from the start does not change the usual quality. As long as some rays are
// not explained, the least certain limb is searched for at intervals.
constexpr double kMaxExplained = 0.985;
constexpr double kMaxCertainDeviation = 0.025;  // metres, of the limb's end
constexpr int64_t kLeastCertainInterval_ns = 500000000;

constexpr double kSearchDeviationFactor = 5.0;  // factor on the standard deviation of the
                                                // prediction during a search

// Contours determine the twist of the trunk poorly while the arms hang, and the twist may drift.
// Beyond kMaxTwist (radians) the pose is also fitted from a start without twist. That fit is taken
// if it is better by kUntwistGain.
constexpr double kMaxTwist = 0.3, kUntwistGain = 0.001;
constexpr int64_t kUntwistInterval_ns = 60000000;

// After a step of so long a time a leg may be nearer to the other one's place than to its own;
// exchanged legs then fit better by more than this.
constexpr double kLongStep = 0.15;  // seconds
constexpr double kExchangeGain = 0.01;

constexpr RobustSchedule kRetry{10, 0.12, 0.03};

// While rays on still contours count less, a limb is well supported if so many of its rays count
// fully, as a fraction of all rays. Another place for it must then be better by this much more: it
// would leave living contours to explain others, such as those of something that is worn.
constexpr double kWellSupported = 0.01, kGainOfSupported = 0.05;

/// The gain that another place of a limb must bring.
double gainFor(ContourLimb::Id limb, const ContourObservation& seen, const ContourFit& fit) {
  const bool reduced = std::any_of(seen.rays.begin(), seen.rays.end(),
                                   [](const ContourRay& ray) { return ray.weight < 1.0f; });
  const bool supported = fit.limbs[limb].full_rays > kWellSupported * double(seen.rays.size());
  return reduced && supported ? kMinGain + kGainOfSupported : kMinGain;
}

bool any(const std::array<bool, ContourLimb::kCount>& limbs) {
  return std::any_of(limbs.begin(), limbs.end(), [](bool limb) { return limb; });
}

/// Rotation of the shoulder line relative to the hips, radians to the left.
double shoulderTurn(const ContourPose& pose) {
  using A = RevoluteJoint;
  return pose.angles[A::kSpineTwist] +
         0.5 * (pose.angles[A::kRightClavicleYaw] - pose.angles[A::kLeftClavicleYaw]);
}

/// The pose without twist: once with the arms unchanged relative to the trunk, once with hanging
/// arms.
std::vector<ContourPose> untwisted(const ContourPose& pose) {
  ContourPose straight = pose;
  for (const int angle : {RevoluteJoint::kSpineTwist, RevoluteJoint::kLeftClavicleYaw,
                          RevoluteJoint::kRightClavicleYaw})
    straight.angles[size_t(angle)] = 0.0;
  return {straight, withArmsAtRest(straight)};
}

}  // namespace

const char* toString(ContourTrackingStatus status) {
  constexpr const char* kNames[] = {"lost", "tracked", "limb recovered", "limb lost"};
  return kNames[size_t(status)];
}

ContourHypothesisTracker::ContourHypothesisTracker(const CameraRig& rig,
                                                   const ContourOptions& options)
    : rig_(rig), fitter_(rig, options) {}

ContourTrackingResult ContourHypothesisTracker::keep(int64_t stamp_ns, const ContourFit& fit,
                                                     ContourTrackingStatus status) {
  if (fit.status != ContourFitStatus::kFitted || fit.overlap < kLostOverlap) {
    last_.reset();
    return {ContourTrackingStatus::kLost, fit};
  }
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
  return {status, fit};
}

ContourFit ContourHypothesisTracker::search(const ContourObservation& seen, const ContourBody& body,
                                            const ContourPose& pose) const {
  ContourFit fit = fitter_.fit(seen, body, pose, std::nullopt, RobustSchedule::wide());
  // Proposals often lack arms, and the arms of a fit may rest at the trunk although they are
  // elsewhere.
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb)
    if (fit.status == ContourFitStatus::kFitted)
      tryPoses(seen, body, limbAlternatives(seen, body, ContourLimb::Id(limb), fit, fit.pose),
               std::nullopt, gainFor(ContourLimb::Id(limb), seen, fit), fit);
  return fit;
}

std::optional<ContourPose> ContourHypothesisTracker::searchLimb(const ContourObservation& seen,
                                                                const ContourBody& body,
                                                                const ContourPose& pose,
                                                                ContourLimb::Id limb) const {
  ContourFit fit = fitter_.fit(seen, body, pose, std::nullopt, kRetry);
  if (fit.status != ContourFitStatus::kFitted ||
      !tryPoses(seen, body, limbAlternatives(seen, body, limb, fit, pose), std::nullopt,
                gainFor(limb, seen, fit), fit))
    return std::nullopt;
  return fit.pose;
}

ContourTrackingResult ContourHypothesisTracker::start(int64_t stamp_ns,
                                                      const ContourObservation& seen,
                                                      const ContourBody& body,
                                                      const ContourPose& pose) {
  return startFrom(stamp_ns, search(seen, body, pose));
}

ContourTrackingResult ContourHypothesisTracker::startFrom(int64_t stamp_ns, const ContourFit& fit) {
  last_.reset();
  next_search_ns_ = stamp_ns;
  next_least_certain_ns_ = nextInstant(stamp_ns, kLeastCertainInterval_ns);
  next_untwist_ns_ = stamp_ns;
  return keep(stamp_ns, fit, ContourTrackingStatus::kTracked);
}

std::array<bool, ContourLimb::kCount> ContourHypothesisTracker::suspicious(
    const ContourFit& fit) const {
  std::array<bool, ContourLimb::kCount> limbs{};
  const bool dropped =
      qualityOf(fit) < last_->quality - kMaxDrop - kDeviationFactor * last_->quality_deviation;
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i)
    limbs[i] = dropped || fit.limbs[i].outside > last_->outside[i] + kLimbOutside;
  return limbs;
}

std::vector<ContourPose> ContourHypothesisTracker::limbAlternatives(
    const ContourObservation& seen, const ContourBody& body, ContourLimb::Id limb,
    const ContourFit& fit, const ContourPose& expected) const {
  return alternativeLimbPoses(seen, rig_, fitter_.options(), body, fit.pose, expected, limb);
}

bool ContourHypothesisTracker::tryPoses(const ContourObservation& seen, const ContourBody& body,
                                        const std::vector<ContourPose>& starts,
                                        const std::optional<ContourPrediction>& prediction,
                                        double gain, ContourFit& fit) const {
  std::vector<ContourFit> others(starts.size());
  tbb::parallel_for(size_t(0), starts.size(), [&](size_t i) {
    others[i] = fitter_.fit(seen, body, starts[i], prediction, kRetry);
  });
  bool better = false;
  gain += kGainPerUnexplained * std::max(0.0, 1.0 - fit.rays_explained - kUsuallyUnexplained);
  for (const ContourFit& other : others) {
    if (other.status != ContourFitStatus::kFitted ||
        (!seen.masks_follow_pose && other.overlap < fit.overlap - kMaxOverlapLoss) ||
        !(qualityOf(other) > qualityOf(fit) + gain))
      continue;
    fit = other;
    better = true;
  }
  return better;
}

bool ContourHypothesisTracker::retry(const ContourObservation& seen, const ContourBody& body,
                                     const ContourPrediction& prediction, Effort effort,
                                     ContourFit& fit) const {
  const ContourPrediction loose{prediction.pose, kSearchDeviationFactor * prediction.seconds};
  bool better = tryPoses(seen, body, {last_->pose}, loose, kMinGain, fit);
  if (prediction.seconds > kLongStep)
    better |=
        tryPoses(seen, body, {withLegsSwapped(body, fit.pose)}, std::nullopt, kExchangeGain, fit);
  if (effort == Effort::kFollow) return better;
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i) {
    if (better && !any(suspicious(fit))) break;
    if (suspicious(fit)[i])
      better |= tryPoses(seen, body,
                         limbAlternatives(seen, body, ContourLimb::Id(i), fit, prediction.pose),
                         loose, gainFor(ContourLimb::Id(i), seen, fit), fit);
  }
  return better;
}

bool ContourHypothesisTracker::searchLeastCertainLimb(const ContourObservation& seen,
                                                      const ContourBody& body,
                                                      const ContourPrediction& prediction,
                                                      ContourFit& fit) const {
  // A limb at contours of something else has a small deviation, but is seldom inside the masks.
  const auto doubt = [&](int i) {
    return fit.limbs[size_t(i)].deviation +
           (seen.masks_follow_pose ? 0.0 : fit.limbs[size_t(i)].part_outside);
  };
  int least_certain = ContourLimb::kLeftArm;
  for (int i = least_certain; i < ContourLimb::kCount; ++i)
    if (doubt(i) > doubt(least_certain)) least_certain = i;
  if (fit.rays_explained > kMaxExplained &&
      fit.limbs[size_t(least_certain)].deviation < kMaxCertainDeviation)
    return false;
  const ContourPrediction loose{prediction.pose, kSearchDeviationFactor * prediction.seconds};
  return tryPoses(
      seen, body,
      limbAlternatives(seen, body, ContourLimb::Id(least_certain), fit, prediction.pose), loose,
      gainFor(ContourLimb::Id(least_certain), seen, fit), fit);
}

bool ContourHypothesisTracker::untwist(const ContourObservation& seen, const ContourBody& body,
                                       const ContourPrediction& prediction, ContourFit& fit) const {
  if (std::abs(shoulderTurn(fit.pose)) < kMaxTwist) return false;
  const ContourPrediction loose{prediction.pose, kSearchDeviationFactor * prediction.seconds};
  return tryPoses(seen, body, untwisted(fit.pose), loose, kUntwistGain, fit);
}

std::optional<ContourPrediction> ContourHypothesisTracker::predict(int64_t stamp_ns) const {
  const int64_t gap = last_ ? stamp_ns - last_->stamp_ns : 0;
  if (!last_ || gap <= 0 || gap > kMaxGap_ns) return std::nullopt;
  return ContourPrediction{
      last_->before ? predictConstantVelocity(*last_->before, last_->pose, kVelocityFraction)
                    : last_->pose,
      1e-9 * double(gap)};
}

std::optional<ContourMotion> ContourHypothesisTracker::motion(int64_t stamp_ns) const {
  const std::optional<ContourPrediction> predicted = predict(stamp_ns);
  if (!predicted || !last_->before) return std::nullopt;
  const double seconds = 1e-9 * double(last_->stamp_ns - last_->before_ns);
  return ContourMotion{predicted->pose, boxMinus(last_->pose, *last_->before) / seconds};
}

ContourTrackingResult ContourHypothesisTracker::update(int64_t stamp_ns,
                                                       const ContourObservation& seen,
                                                       const ContourBody& body, Effort effort) {
  const std::optional<ContourPrediction> predicted = predict(stamp_ns);
  if (!predicted) {
    last_.reset();
    return {};
  }
  const ContourPrediction& prediction = *predicted;
  ContourFit fit =
      fitter_.fit(seen, body, prediction.pose, prediction, fitter_.schedule(prediction.seconds));
  ContourTrackingStatus status = ContourTrackingStatus::kTracked;
  if (fit.status == ContourFitStatus::kFitted && any(suspicious(fit))) {
    const bool search = stamp_ns >= next_search_ns_;
    const bool better = search && retry(seen, body, prediction, effort, fit);
    if (search && !better && effort == Effort::kSearch)
      next_search_ns_ = nextInstant(stamp_ns, kSearchInterval_ns);
    status = any(suspicious(fit)) ? ContourTrackingStatus::kLimbLost
             : better             ? ContourTrackingStatus::kLimbRecovered
                                  : ContourTrackingStatus::kTracked;
  }
  if (effort == Effort::kSearch && fit.status == ContourFitStatus::kFitted &&
      stamp_ns >= next_least_certain_ns_) {
    next_least_certain_ns_ = nextInstant(stamp_ns, kLeastCertainInterval_ns);
    if (searchLeastCertainLimb(seen, body, prediction, fit))
      status = ContourTrackingStatus::kLimbRecovered;
  }
  if (fit.status == ContourFitStatus::kFitted && stamp_ns >= next_untwist_ns_) {
    next_untwist_ns_ = nextInstant(stamp_ns, kUntwistInterval_ns);
    if (untwist(seen, body, prediction, fit)) status = ContourTrackingStatus::kLimbRecovered;
  }
  return keep(stamp_ns, fit, status);
}

}  // namespace markerless_mocap
