#pragma once

#include <array>

#include "contour/fit/contour_observation.h"
#include "contour/model/normal_equations.h"

namespace markerless_mocap {

/// Spheres per cone that must lie inside all masks.
constexpr int kSpheresPerCone = 4;

/// For each sphere, the maximum distance over all views by which it lies outside a mask, metres; 0
/// if it is inside all of them.
using SphereViolation = std::array<std::array<double, kSpheresPerCone>, kContourCones>;

/// Adds one residual for each sphere and each usable mask that it leaves: the distance outside the
/// mask, in metres at the depth of the sphere, of the views from `first` to before `end`. A view is
/// ignored if the centre of the sphere is not in its image. The derivatives neglect the variation
/// of the lens distortion. \param weight of a residual before robust weighting, 1/m^2
SphereViolation addContainment(const ContourObservation& seen, const CameraRig& rig,
                               const ContourWorldCones& cones, double weight, size_t first,
                               size_t end, AllConeNormalEquations& sums);

/// Sum of the robust losses of all containment residuals of a limb, in all views, m^2.
double containmentEnergy(const ContourObservation& seen, const CameraRig& rig,
                         const ContourWorldCones& cones, ContourLimb::Id limb);

}  // namespace markerless_mocap
