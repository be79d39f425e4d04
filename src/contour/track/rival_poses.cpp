#include "contour/track/rival_poses.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "contour/fit/pose_priors.h"
#include "contour/track/exchanged_sides.h"
#include "contour/track/limb_search.h"

namespace markerless_mocap {
namespace {

constexpr double kMinGain = 0.004;  // of the quality

// Where much of the contours is not the person's, a limb that explains some of them proves little.
// Another pose must be better by this much more for each ray beyond kUsuallyUnexplained (fractions
// of all rays) that the current one does not explain.
constexpr double kGainPerUnexplained = 0.15, kUsuallyUnexplained = 0.1;

// Another pose that explains more contours but covers the masks less by this much puts a limb where
// the contours of something else are.
constexpr double kMaxOverlapLoss = 0.005;

// An arm that was lost from the start does not change the usual quality. As long as some rays are
// not explained, the least certain limb is searched for.
constexpr double kMaxExplained = 0.985;
constexpr double kMaxCertainDeviation = 0.025;  // metres, of the limb's end

// Factor on the standard deviation of the prediction during a search.
constexpr double kSearchDeviationFactor = 5.0;

// Contours determine the twist of the trunk poorly while the arms hang, and the twist may drift.
// Beyond kMaxTwist (radians) the pose is also fitted from a start without twist. That fit is taken
// if it is better by kUntwistGain.
constexpr double kMaxTwist = 0.3, kUntwistGain = 0.001;

// After a step of so long a time a leg may be nearer to the other one's place than to its own;
// exchanged legs then fit better by more than this.
constexpr double kLongStep = 0.15;  // seconds
constexpr double kExchangeGain = 0.01;

constexpr RobustSchedule kRetry{10, 0.12, 0.03};

ContourPrediction loosened(const ContourPrediction& prediction) {
  return {prediction.pose, kSearchDeviationFactor * prediction.seconds};
}

ContourLimb::Id leastCertainLimb(const ContourObservation& seen, const ContourFit& fit) {
  // A limb at contours of something else has a small deviation, but is seldom inside the masks.
  const auto doubt = [&](int i) {
    return fit.limbs[size_t(i)].deviation +
           (seen.masks_follow_pose ? 0.0 : fit.limbs[size_t(i)].part_outside);
  };
  int least_certain = ContourLimb::kLeftArm;
  for (int i = least_certain; i < ContourLimb::kCount; ++i)
    if (doubt(i) > doubt(least_certain)) least_certain = i;
  return ContourLimb::Id(least_certain);
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

RivalPoses::RivalPoses(const CameraRig& rig, const ContourOptions& options)
    : rig_(rig), fitter_(rig, options) {}

ContourFit RivalPoses::search(const FittedFrame& now, const ContourPose& pose) const {
  ContourFit fit = fitter_.fit(now.seen, now.body, pose, std::nullopt, RobustSchedule::wide());
  // Proposals often lack arms, and the arms of a fit may rest at the trunk although they are
  // elsewhere.
  for (int limb = ContourLimb::kLeftArm; limb < ContourLimb::kCount; ++limb)
    if (fit.status == ContourFitStatus::kFitted)
      tryLimb(now, ContourLimb::Id(limb), fit.pose, std::nullopt, &fit);
  return fit;
}

std::optional<ContourPose> RivalPoses::searchLimb(const FittedFrame& now, const ContourPose& pose,
                                                  ContourLimb::Id limb) const {
  ContourFit fit = fitter_.fit(now.seen, now.body, pose, std::nullopt, kRetry);
  if (fit.status != ContourFitStatus::kFitted || !tryLimb(now, limb, pose, std::nullopt, &fit))
    return std::nullopt;
  return fit.pose;
}

bool RivalPoses::tryLastPose(const FittedFrame& now, const PoseHistory& history,
                             const ContourPrediction& prediction, ContourFit* fit) const {
  bool better = tryPoses(now, {history.last()}, loosened(prediction), kMinGain, fit);
  if (prediction.seconds > kLongStep)
    better |=
        tryPoses(now, {withLegsSwapped(now.body, fit->pose)}, std::nullopt, kExchangeGain, fit);
  return better;
}

bool RivalPoses::searchLimbNear(const FittedFrame& now, ContourLimb::Id limb,
                                const ContourPrediction& prediction, ContourFit* fit) const {
  return tryLimb(now, limb, prediction.pose, loosened(prediction), fit);
}

bool RivalPoses::searchLeastCertainLimb(const FittedFrame& now, const ContourPrediction& prediction,
                                        ContourFit* fit) const {
  const ContourLimb::Id limb = leastCertainLimb(now.seen, *fit);
  if (fit->rays_explained > kMaxExplained && fit->limbs[limb].deviation < kMaxCertainDeviation)
    return false;
  return searchLimbNear(now, limb, prediction, fit);
}

bool RivalPoses::untwist(const FittedFrame& now, const ContourPrediction& prediction,
                         ContourFit* fit) const {
  if (std::abs(shoulderTurn(fit->pose)) < kMaxTwist) return false;
  return tryPoses(now, untwisted(fit->pose), loosened(prediction), kUntwistGain, fit);
}

bool RivalPoses::tryPoses(const FittedFrame& now, const std::vector<ContourPose>& starts,
                          const std::optional<ContourPrediction>& prediction, double gain,
                          ContourFit* fit) const {
  std::vector<ContourFit> others(starts.size());
  tbb::parallel_for(size_t(0), starts.size(), [&](size_t i) {
    others[i] = fitter_.fit(now.seen, now.body, starts[i], prediction, kRetry);
  });
  bool better = false;
  gain += kGainPerUnexplained * std::max(0.0, 1.0 - fit->rays_explained - kUsuallyUnexplained);
  for (const ContourFit& other : others) {
    if (other.status != ContourFitStatus::kFitted ||
        (!now.seen.masks_follow_pose && other.overlap < fit->overlap - kMaxOverlapLoss) ||
        !(qualityOf(other) > qualityOf(*fit) + gain))
      continue;
    *fit = other;
    better = true;
  }
  return better;
}

bool RivalPoses::tryLimb(const FittedFrame& now, ContourLimb::Id limb, const ContourPose& expected,
                         const std::optional<ContourPrediction>& prediction,
                         ContourFit* fit) const {
  return tryPoses(
      now,
      alternativeLimbPoses(now.seen, rig_, fitter_.options(), now.body, fit->pose, expected, limb),
      prediction, kMinGain, fit);
}

}  // namespace markerless_mocap
