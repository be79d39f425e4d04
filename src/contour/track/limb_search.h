#pragma once

#include <vector>

#include "contour/fit/contour_fitter.h"

namespace markerless_mocap {

/// Poses that differ from `fitted` in one arm or leg only. Many positions around the expected one
/// are sampled. The result is the few best, far apart, that stay inside the masks and explain the
/// rays that nothing else explains. Deterministic.
std::vector<ContourPose> alternativeLimbPoses(const ContourObservation& seen, const CameraRig& rig,
                                              const ContourOptions& options,
                                              const ContourBody& body, const ContourPose& fitted,
                                              const ContourPose& expected, ContourLimb::Id limb);

}  // namespace markerless_mocap
