#pragma once

#include <vector>

#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// Poses that differ from `fit` in one arm or leg only: of many places around where the limb is
/// expected the few, far apart, that stay inside the masks best and explain most of the rays that
/// nothing explains yet. Always the same ones for the same arguments.
/// \param limb one of kLeftArm to kRightLeg
std::vector<ContourPose> alternativeLimbPoses(const ContourObservation& seen, const CameraRig& rig,
                                              const ContourOptions& options,
                                              const ContourBody& body, const ContourPose& fitted,
                                              const ContourPose& expected, ContourLimb::Id limb);

}  // namespace markerless_mocap
