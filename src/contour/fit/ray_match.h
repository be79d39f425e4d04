#pragma once

#include <cstddef>
#include <vector>

#include "contour/fit/contour_observation.h"
#include "contour/model/contour_body.h"

namespace markerless_mocap {

/// Cones as structure of arrays, padded to whole SIMD vectors with the first cone, which comes
/// before its copies wherever they are as near.
struct PackedContourCones {
  static constexpr int kLanes = 24;
  float ax[kLanes], ay[kLanes], az[kLanes];  ///< a
  float ux[kLanes], uy[kLanes], uz[kLanes];  ///< from a to b
  float radius[kLanes], taper[kLanes];       ///< at a; at b minus at a

  explicit PackedContourCones(const ContourWorldCones& cones);
};

/// The body as each view shows it.
class ConesInViews {
 public:
  /// \param cones at the time of the observation
  ConesInViews(const ContourObservation& seen, const ContourWorldCones& cones);
  const PackedContourCones& operator[](int camera) const {
    return packed_[packed_.size() == 1 ? 0 : size_t(camera)];
  }

 private:
  std::vector<PackedContourCones> packed_;  ///< one if all views are of one time
};

/// The cone that a ray is assumed to touch.
struct RayMatch {
  int cone;
  float s;         ///< point on its axis, 0 at a, 1 at b
  float residual;  ///< distance from ray to surface, metres; negative if the ray intersects the
                   ///< cone
  float along_normal, along_side;  ///< derivative of the residual with respect to the axis point
};

/// Finds for each ray the cone with minimum |distance| + kTurnPenalty (1 - cos), where the angle is
/// between the contour's normal and the direction from the cone's axis to the ray. If a cone lies
/// on the wrong side of its contour, the distance is measured along the normal, which pulls the
/// cone back through the contour.
void matchRays(const ConesInViews& cones, const std::vector<ContourRay>& rays,
               std::vector<RayMatch>& matches);
/// The same of the rays from `first` to before `end`; `matches` has the size of `rays`.
void matchRays(const ConesInViews& cones, const std::vector<ContourRay>& rays, size_t first,
               size_t end, std::vector<RayMatch>& matches);

}  // namespace markerless_mocap
