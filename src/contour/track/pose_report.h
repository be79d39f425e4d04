#pragma once

#include <array>
#include <string>

#include "contour/track/contour_multi_hypothesis_tracker.h"
#include "markerless_mocap/products/body_pose.h"

namespace markerless_mocap {

/// With less of the person found by colours confirmed by silhouettes, a limb is not seen.
constexpr double kMinLimbAgreement = 0.6;

/// Sets overlap, expected errors, the parts that are seen, and the reason if some are not.
/// \param limb_agreement see RegionMasks
void reportEvidence(const ContourFit& fit,
                    const std::array<double, ContourLimb::kCount>& limb_agreement, BodyPose& pose);

// Why no pose is reported, in words for the user.

std::string overlapTooSmall(const ContourFit& fit);
/// \param initializer_error why no pose was proposed; may be empty
std::string whyLost(const ContourObservation& seen, const ContourFit& fit,
                    const std::string& initializer_error);
/// Of a good fit that is not accepted yet.
std::string whyUncertain(const ContourMultiHypothesisTracker& hypotheses);

}  // namespace markerless_mocap
