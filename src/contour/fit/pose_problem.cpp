#include "contour/fit/pose_problem.h"

#include <algorithm>
#include <cmath>

#include "contour/fit/geman_mcclure.h"

namespace markerless_mocap {

void PoseProblem::evaluate(const ContourBody& body, const ContourPose& pose, double outlier) {
  body.place(pose, frames_);
  body.place(frames_, cones_);
  for (ConeNormalEquations& sum : sums_) sum.clear();
  addRays(outlier);
  const double weight = options_.containment_weight / (options_.ray_sigma * options_.ray_sigma);
  violation_ = addContainment(seen_, rig_, cones_, weight, sums_);
}

void PoseProblem::addRays(double outlier) {
  matchRays(PackedContourCones(cones_), seen_.rays, matches_);
  const double one = options_.effective_rays / (options_.ray_sigma * options_.ray_sigma) /
                     std::max(1.0, double(seen_.rays.size()));
  for (size_t i = 0; i < matches_.size(); ++i)
    addRay(seen_.rays[i], matches_[i],
           one * seen_.rays[i].weight * gemanMcClureWeight(matches_[i].residual, outlier), sums_);
}

void addRay(const ContourRay& ray, const RayMatch& match, double weight,
            AllConeNormalEquations& sums) {
  const Eigen::Vector3f slope = match.along_normal * ray.normal + match.along_side * ray.side;
  const double u[4] = {slope.x(), slope.y(), slope.z(), -1.0};
  sums[size_t(match.cone)].add(match.s, u, match.residual, weight);
}

double robustScaleAt(const RobustSchedule& schedule, int iteration) {
  const double fraction =
      schedule.iterations > 1 ? double(iteration) / (schedule.iterations - 1) : 1;
  return schedule.robust_scale_initial *
         std::pow(schedule.robust_scale_final / schedule.robust_scale_initial, fraction);
}

}  // namespace markerless_mocap
