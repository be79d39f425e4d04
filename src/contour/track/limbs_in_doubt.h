#pragma once

#include <optional>

#include "contour/track/contour_multi_hypothesis_tracker.h"

namespace markerless_mocap {

/// Where masks are in doubt, a limb that is not where it was predicted is as unknown as a box
/// beside it: nothing draws the body back to it. This looks for such limbs.
/// \param seen made of masks in which only what is far too large for a limb is unknown: those of
///   withoutThingsBeside() without images
/// \param fit to what was left of the masks, and colours
/// \return a fit to `seen` with limbs elsewhere; empty if it does not cover clearly more of the
///   masks, or if they hardly overlap less with `fit` than what it was fitted to
std::optional<ContourFit> findLimbsInDoubt(const ContourMultiHypothesisTracker& tracker,
                                           const ContourObservation& seen, const CameraRig& rig,
                                           const ContourBody& body, const ContourFit& fit);

}  // namespace markerless_mocap
