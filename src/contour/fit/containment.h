#pragma once

#include <array>

#include "contour/model/cone_sums.h"
#include "contour/fit/contour_observation.h"

namespace markerless_mocap {

/// Balls per cone that must lie inside every mask.
constexpr int kBallsPerCone = 4;

/// By how much each ball sticks out of the mask it sticks out of most, metres, 0 if of none.
using BallExcess = std::array<std::array<double, kBallsPerCone>, kContourCones>;

/// Adds a residual for each ball of the body that leaves a usable mask: by how much, metres, at the
/// ball's depth. A camera that does not have the ball's middle in its image says nothing. The
/// derivatives leave the change of the lens' distortion out.
/// \param weight of a residual before it is taken for an outlier, 1/m^2
BallExcess addContainment(const ContourObservation& seen, const CameraRig& rig,
                          const PlacedCones& cones, double weight, AllConeSums& sums);

/// Sum of robust squares of what sticks out of a limb, in all views, m^2.
double excessEnergy(const ContourObservation& seen, const CameraRig& rig, const PlacedCones& cones,
                    ContourLimb::Id limb);

}  // namespace markerless_mocap
