#pragma once

#include <cstddef>
#include <vector>

#include "contour/fit/contour_observation.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// Cones side by side, padded to whole vectors with cones that no ray is near to.
struct PackedContourCones {
  static constexpr int kLanes = 24;
  float ax[kLanes], ay[kLanes], az[kLanes], ra[kLanes];
  float bx[kLanes], by[kLanes], bz[kLanes], rb[kLanes];

  explicit PackedContourCones(const ContourWorldCones& cones);
};

/// The cone that a ray is taken to touch.
struct RayMatch {
  int cone;
  float s;         ///< where on its axis, 0 at a, 1 at b
  float residual;  ///< distance from ray to surface, metres; negative when the ray cuts the cone
  float along_normal, along_side;  ///< the residual's derivative by the axis point there
};

/// For each ray the cone to which |distance| + kTurnPenalty (1 - cos) is least; the angle is
/// between the border's normal and the way from the cone's axis to the ray. A cone on the wrong
/// side of its border is measured along the normal, which pulls it back through.
void matchRays(const PackedContourCones& cones, const std::vector<ContourRay>& rays,
               std::vector<RayMatch>& matches);

}  // namespace markerless_mocap
