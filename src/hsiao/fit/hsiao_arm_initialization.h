#pragma once

#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// The data limb that corresponds to the model's limb of `side` (0 left, 1 right), by the distance
/// of their roots. \param first PartLabel::kArm1 or kLeg1; at least one of the two must be seen
PartLabel limbOfSide(const HsiaoSkeletonError& error, const HsiaoBodyModel& body_model,
                     const HsiaoFrames& frames, PartLabel first, int side);

/// Computes the arm of `side` from its curve in closed form: the upper arm points to the expected
/// position of the elbow on the curve, the forearm to that of the wrist. Of the two sets of
/// shoulder angles the one within the limits is chosen, or else the one nearer to `v`. A straight
/// arm keeps its twist.
void initializeArm(const HsiaoSkeletonError& error, const HsiaoBodyModel& body_model,
                   const HsiaoLimits& limits, int side, HsiaoVector& v);

}  // namespace markerless_mocap
