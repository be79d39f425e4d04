#pragma once

#include <array>

#include "contour/fit/contour_observation.h"
#include "contour/model/normal_equations.h"

namespace markerless_mocap {

/// Balls per cone that must lie inside every mask.
constexpr int kSpheresPerCone = 4;

/// By how much each ball sticks out of the mask it sticks out of most, metres, 0 if of none.
using SphereViolation = std::array<std::array<double, kSpheresPerCone>, kContourCones>;

/// Adds a residual for each ball of the body that leaves a usable mask: by how much, metres, at the
/// ball's depth. A camera that does not have the ball's middle in its image says nothing. The
/// derivatives leave the change of the lens' distortion out.
/// \param weight of a residual before it is taken for an outlier, 1/m^2
SphereViolation addContainment(const ContourObservation& seen, const CameraRig& rig,
                               const ContourWorldCones& cones, double weight,
                               AllConeNormalEquations& sums);

/// Sum of robust squares of what sticks out of a limb, in all views, m^2.
double containmentEnergy(const ContourObservation& seen, const CameraRig& rig,
                         const ContourWorldCones& cones, ContourLimb::Id limb);

}  // namespace markerless_mocap
