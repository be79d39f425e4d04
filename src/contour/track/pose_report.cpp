#include "contour/track/pose_report.h"

#include <cstdio>

namespace markerless_mocap {
namespace {

// A limb counts as seen if the standard deviation of its end is below the first value (posture
// priors alone give an arm 0.1) and if no part of an arm or leg, nor trunk or head on average, lies
// outside the masks by more than the second.
constexpr double kMaxSeenDeviation = 0.08, kMaxSeenOutside = 0.10;  // metres
// And if less of it is inside the trunk: masks that lack a limb let it fit nowhere else. Of legs
// that are seen, also of somebody who sits, 0.12 is; of arms that hang or are on the hips, 0.33.
constexpr double kMaxSeenLegInside = 0.4, kMaxSeenArmInside = 0.6;
// An arm that the masks lack is also folded as far as the elbow allows, 2.7. Somebody who guards
// their face bends it by 2.5.
constexpr double kMaxSeenElbow = 2.6;  // radians

/// The limb of a body part.
ContourLimb::Id limbOf(int part) {
  constexpr ContourLimb::Id kLimbs[kPartCount] = {ContourLimb::kTrunk,   ContourLimb::kHead,
                                                  ContourLimb::kLeftArm, ContourLimb::kRightArm,
                                                  ContourLimb::kLeftLeg, ContourLimb::kRightLeg};
  return kLimbs[part];
}

/// Whether a limb is where it fits if the masks lack it.
bool isHidden(const ContourFit& fit, ContourLimb::Id limb) {
  const double inside = fit.limbs[limb].inside;
  if (limb != ContourLimb::kLeftArm && limb != ContourLimb::kRightArm)
    return inside > kMaxSeenLegInside;
  const auto elbow =
      limb == ContourLimb::kLeftArm ? RevoluteJoint::kLeftElbow : RevoluteJoint::kRightElbow;
  return inside > kMaxSeenArmInside || fit.pose.angles[elbow] > kMaxSeenElbow;
}

}  // namespace

void reportEvidence(const ContourFit& fit,
                    const std::array<double, ContourLimb::kCount>& limb_agreement, BodyPose& pose) {
  pose.silhouette_overlap = fit.overlap;
  for (int part = 0; part < kPartCount; ++part) {
    const LimbEvidence& limb = fit.limbs[limbOf(part)];
    pose.part_sigma_m[size_t(part)] = limb.deviation;
    const bool is_trunk_or_head = limbOf(part) < ContourLimb::kLeftArm;
    const double outside = is_trunk_or_head ? limb.outside : limb.part_outside;
    pose.part_seen[size_t(part)] = limb.deviation < kMaxSeenDeviation &&
                                   outside < kMaxSeenOutside && !isHidden(fit, limbOf(part)) &&
                                   limb_agreement[limbOf(part)] >= kMinLimbAgreement;
  }
  pose.reason = unseenParts(pose.part_seen);
}

std::string overlapTooSmall(const ContourFit& fit) {
  char overlap[32];
  std::snprintf(overlap, sizeof overlap, "%.2f", fit.overlap);
  return std::string("no pose covers the silhouettes, the best overlap is ") + overlap;
}

std::string whyLost(const ContourObservation& seen, const ContourFit& fit,
                    const std::string& initializer_error) {
  if (seen.usableViews() < 2)
    return "the person is visible in " + std::to_string(seen.usableViews()) +
           " silhouettes, at least 2 are needed";
  if (fit.status == ContourFitStatus::kFitted) return overlapTooSmall(fit);
  return initializer_error.empty() ? "no pose covers the silhouettes" : initializer_error;
}

std::string whyUncertain(const ContourMultiHypothesisTracker& hypotheses) {
  if (!hypotheses.isUnambiguous())
    return "a person was found, but front and back cannot be distinguished yet";
  return hypotheses.isConfirmed() ? "something like a person was found, but it has not moved yet"
                                  : "a person was found, but another frame must confirm the pose";
}

}  // namespace markerless_mocap
