#include "contour/track/contour_hypothesis_tracker.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "contour/fit/pose_priors.h"
#include "contour/track/limb_search.h"

namespace markerless_mocap {
namespace {

constexpr double kVelocityKept = 0.7;  // of the last frame's, in the prediction
constexpr int64_t kLongestGap_ns = 500000000;

// Below this overlap there is no person there.
constexpr double kLostOverlap = 0.65;

// Quality, see below: a drop by the first below what is usual is suspicious; another pose must be
// better by the second to be taken; the usual value follows by the share.
constexpr double kDrop = 0.015, kGain = 0.004;
constexpr double kMoreThanUsual = 1.5;  // damaged masks let the quality vary
constexpr double kUsualShare = 0.1;

constexpr int64_t kBetweenSearches_ns = 150000000;  // after one that found nothing

// A limb that sticks out of masks by so much more than usual, mean over its balls, is suspicious:
// damaged masks and clothes let limbs that fit stick out, too.
constexpr double kLimbOutside = 0.025;  // metres

// An arm that has been lost from the start on is usual. While rays are left over, the limb that is
// least certain is looked for now and then.
constexpr double kAllExplained = 0.985;
constexpr double kUncertain = 0.025;  // metres, of its end
constexpr int64_t kBetweenLooks_ns = 500000000;

constexpr double kLooser = 5.0;  // is the prediction when a limb is looked for

// Contours hardly tell how far a trunk with hanging arms is turned against the pelvis, and it may
// slide on and on. Beyond the first, radians, it is also fitted from where it is not turned, and
// that pose is taken if it is better by the second.
constexpr double kTwisted = 0.3, kUntwistedGain = 0.001;
constexpr int64_t kBetweenUntwists_ns = 60000000;

constexpr RobustSchedule kRetry{10, 0.12, 0.03};

bool any(const std::array<bool, ContourLimb::kCount>& limbs) {
  return std::any_of(limbs.begin(), limbs.end(), [](bool limb) { return limb; });
}

/// By how much the line through the shoulders is turned against the hips, radians to the left.
double shoulderTurn(const ContourPose& pose) {
  using A = RevoluteJoint;
  return pose.angles[A::kSpineTwist] +
         0.5 * (pose.angles[A::kRightClavicleYaw] - pose.angles[A::kLeftClavicleYaw]);
}

/// The pose with shoulders above the hips: arms as they were against the trunk, and hanging.
std::vector<ContourPose> untwisted(const ContourPose& pose) {
  ContourPose straight = pose;
  for (const int angle : {RevoluteJoint::kSpineTwist, RevoluteJoint::kLeftClavicleYaw,
                          RevoluteJoint::kRightClavicleYaw})
    straight.angles[size_t(angle)] = 0.0;
  return {straight, withArmsAtRest(straight)};
}

}  // namespace

const char* toString(ContourTrackingStatus status) {
  constexpr const char* kNames[] = {"lost", "tracked", "recovered", "doubtful"};
  return kNames[size_t(status)];
}

ContourTracker::ContourTracker(const CameraRig& rig, const ContourOptions& options)
    : rig_(rig), fitter_(rig, options) {}

ContourTrackingResult ContourTracker::keep(int64_t stamp_ns, const ContourFit& fit,
                                           ContourTrackingStatus status) {
  if (fit.status != ContourFitStatus::kFitted || fit.overlap < kLostOverlap) {
    last_.reset();
    return {ContourTrackingStatus::kLost, fit};
  }
  Past past{stamp_ns, fit.pose, std::nullopt, qualityOf(fit), 0.0, {}};
  for (size_t i = 0; i < past.outside.size(); ++i) past.outside[i] = fit.limbs[i].outside;
  if (last_) {
    past.before = last_->pose;
    // Gets better at once and worse slowly, so that a loss does not become what is usual.
    const double below = std::max(0.0, last_->quality - past.quality);
    past.quality = std::max(past.quality, last_->quality - kUsualShare * below);
    past.below = last_->below + kUsualShare * (below - last_->below);
    for (size_t i = 0; i < past.outside.size(); ++i)
      past.outside[i] = std::min(
          past.outside[i], last_->outside[i] + kUsualShare * (past.outside[i] - last_->outside[i]));
  }
  last_ = past;
  return {status, fit};
}

ContourTrackingResult ContourTracker::start(int64_t stamp_ns, const ContourObservation& seen,
                                            const ContourBody& body, const ContourPose& pose) {
  ContourFit fit = fitter_.fit(seen, body, pose, std::nullopt, RobustSchedule::wide());
  // Proposals often lack arms, and an arm at rest may hide one that is elsewhere.
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb)
    if (fit.status == ContourFitStatus::kFitted)
      tryPoses(seen, body, limbAlternatives(seen, body, ContourLimb::Id(limb), fit, fit.pose),
               std::nullopt, kGain, fit);
  return startFrom(stamp_ns, fit);
}

ContourTrackingResult ContourTracker::startFrom(int64_t stamp_ns, const ContourFit& fit) {
  last_.reset();
  next_search_ns_ = stamp_ns;
  next_look_ns_ = stamp_ns + kBetweenLooks_ns;
  next_untwist_ns_ = stamp_ns;
  return keep(stamp_ns, fit, ContourTrackingStatus::kTracked);
}

std::array<bool, ContourLimb::kCount> ContourTracker::suspicious(const ContourFit& fit) const {
  std::array<bool, ContourLimb::kCount> limbs{};
  const bool dropped = qualityOf(fit) < last_->quality - kDrop - kMoreThanUsual * last_->below;
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i)
    limbs[i] = dropped || fit.limbs[i].outside > last_->outside[i] + kLimbOutside;
  return limbs;
}

std::vector<ContourPose> ContourTracker::limbAlternatives(const ContourObservation& seen,
                                                          const ContourBody& body,
                                                          ContourLimb::Id limb,
                                                          const ContourFit& fit,
                                                          const ContourPose& expected) const {
  return alternativeLimbPoses(seen, rig_, fitter_.options(), body, fit.pose, expected, limb);
}

bool ContourTracker::tryPoses(const ContourObservation& seen, const ContourBody& body,
                              const std::vector<ContourPose>& starts,
                              const std::optional<ContourPrediction>& prediction, double gain,
                              ContourFit& fit) const {
  std::vector<ContourFit> others(starts.size());
  tbb::parallel_for(size_t(0), starts.size(), [&](size_t i) {
    others[i] = fitter_.fit(seen, body, starts[i], prediction, kRetry);
  });
  bool better = false;
  for (const ContourFit& other : others) {
    if (other.status != ContourFitStatus::kFitted || !(qualityOf(other) > qualityOf(fit) + gain))
      continue;
    fit = other;
    better = true;
  }
  return better;
}

bool ContourTracker::retry(const ContourObservation& seen, const ContourBody& body,
                           const ContourPrediction& prediction, ContourFit& fit) const {
  const ContourPrediction loose{prediction.pose, kLooser * prediction.seconds};
  bool better = tryPoses(seen, body, {last_->pose}, loose, kGain, fit);
  for (size_t i = ContourLimb::kLeftArm; i < ContourLimb::kCount; ++i) {
    if (better && !any(suspicious(fit))) break;
    if (suspicious(fit)[i])
      better |= tryPoses(seen, body,
                         limbAlternatives(seen, body, ContourLimb::Id(i), fit, prediction.pose),
                         loose, kGain, fit);
  }
  return better;
}

bool ContourTracker::searchLeastCertainLimb(const ContourObservation& seen, const ContourBody& body,
                                            const ContourPrediction& prediction,
                                            ContourFit& fit) const {
  int weakest = ContourLimb::kLeftArm;
  for (int i = weakest; i < ContourLimb::kCount; ++i)
    if (fit.limbs[size_t(i)].deviation > fit.limbs[size_t(weakest)].deviation) weakest = i;
  if (fit.rays_explained > kAllExplained && fit.limbs[size_t(weakest)].deviation < kUncertain)
    return false;
  const ContourPrediction loose{prediction.pose, kLooser * prediction.seconds};
  return tryPoses(seen, body,
                  limbAlternatives(seen, body, ContourLimb::Id(weakest), fit, prediction.pose),
                  loose, kGain, fit);
}

bool ContourTracker::untwist(const ContourObservation& seen, const ContourBody& body,
                             const ContourPrediction& prediction, ContourFit& fit) const {
  if (std::abs(shoulderTurn(fit.pose)) < kTwisted) return false;
  const ContourPrediction loose{prediction.pose, kLooser * prediction.seconds};
  return tryPoses(seen, body, untwisted(fit.pose), loose, kUntwistedGain, fit);
}

ContourTrackingResult ContourTracker::update(int64_t stamp_ns, const ContourObservation& seen,
                                             const ContourBody& body) {
  const int64_t gap = last_ ? stamp_ns - last_->stamp_ns : 0;
  if (!last_ || gap <= 0 || gap > kLongestGap_ns) {
    last_.reset();
    return {};
  }
  const ContourPrediction prediction{
      last_->before ? predictConstantVelocity(*last_->before, last_->pose, kVelocityKept)
                    : last_->pose,
      1e-9 * double(gap)};
  ContourFit fit = fitter_.fit(seen, body, prediction.pose, prediction, fitter_.schedule());
  ContourTrackingStatus status = ContourTrackingStatus::kTracked;
  if (fit.status == ContourFitStatus::kFitted && any(suspicious(fit))) {
    const bool search = stamp_ns > next_search_ns_;
    const bool better = search && retry(seen, body, prediction, fit);
    if (search && !better) next_search_ns_ = stamp_ns + kBetweenSearches_ns;
    status = any(suspicious(fit)) ? ContourTrackingStatus::kLimbLost
             : better             ? ContourTrackingStatus::kLimbRecovered
                                  : ContourTrackingStatus::kTracked;
  }
  if (fit.status == ContourFitStatus::kFitted && stamp_ns > next_look_ns_) {
    next_look_ns_ = stamp_ns + kBetweenLooks_ns;
    if (searchLeastCertainLimb(seen, body, prediction, fit))
      status = ContourTrackingStatus::kLimbRecovered;
  }
  if (fit.status == ContourFitStatus::kFitted && stamp_ns > next_untwist_ns_) {
    next_untwist_ns_ = stamp_ns + kBetweenUntwists_ns;
    if (untwist(seen, body, prediction, fit)) status = ContourTrackingStatus::kLimbRecovered;
  }
  return keep(stamp_ns, fit, status);
}

}  // namespace markerless_mocap
