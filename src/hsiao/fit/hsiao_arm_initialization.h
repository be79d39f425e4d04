#pragma once

#include "hsiao/fit/hsiao_skeleton_error.h"
#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// The data limb that belongs to the model's limb of `side` (0 left, 1 right), judged by the limbs'
/// roots. \param first PartLabel::kArm1 or kLeg1; at least one of the two must be seen
PartLabel limbOfSide(const HsiaoSkeletonError& error, const HsiaoBodyModel& profile,
                     const HsiaoFrames& frames, PartLabel first, int side);

/// Lays the arm of `side` on its curve in closed form: upper arm to where the elbow should be on
/// the curve, forearm to where the wrist should be. Of the two sets of shoulder angles the one
/// inside the limits, or else nearer to `v`, is taken. A straight arm keeps its twist.
void initializeArm(const HsiaoSkeletonError& error, const HsiaoBodyModel& profile,
                   const HsiaoLimits& limits, int side, HsiaoVector& v);

}  // namespace markerless_mocap
