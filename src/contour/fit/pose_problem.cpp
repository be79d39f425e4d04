#include "contour/fit/pose_problem.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "contour/fit/geman_mcclure.h"
#include "contour/fit/view_times.h"

namespace markerless_mocap {
namespace {

constexpr size_t kRayBlocks = 4, kViewBlocks = 4;

}  // namespace

void PoseProblem::evaluate(const ContourBody& body, const ContourPose& pose, double outlier) {
  body.place(pose, frames_);
  body.place(frames_, cones_);
  blocks_.assign(kRayBlocks + kViewBlocks, {});
  const ConesInViews packed(seen_, cones_);
  tbb::parallel_for(size_t(0), kRayBlocks + kViewBlocks, [&](size_t block) {
    if (block < kRayBlocks)
      addRays(packed, outlier, block);
    else
      addViews(block);
  });
  for (ConeNormalEquations& sum : sums_) sum.clear();
  violation_ = {};
  for (const Block& block : blocks_)
    for (size_t cone = 0; cone < kContourCones; ++cone) {
      sums_[cone].add(block.sums[cone]);
      for (size_t i = 0; i < kSpheresPerCone; ++i)
        violation_[cone][i] = std::max(violation_[cone][i], block.violation[cone][i]);
    }
}

void PoseProblem::addViews(size_t block) {
  const double weight = options_.containment_weight / (options_.ray_sigma * options_.ray_sigma);
  const size_t i = block - kRayBlocks, views = rig_.size();
  blocks_[block].violation = addContainment(seen_, rig_, cones_, weight, i * views / kViewBlocks,
                                            (i + 1) * views / kViewBlocks, blocks_[block].sums);
}

void PoseProblem::addRays(const ConesInViews& cones, double outlier, size_t block) {
  const size_t rays = seen_.rays.size(), first = block * rays / kRayBlocks,
               end = (block + 1) * rays / kRayBlocks;
  matchRays(cones, seen_.rays, first, end, matches_);
  const double one = options_.effective_rays / (options_.ray_sigma * options_.ray_sigma) /
                     std::max(1.0, double(seen_.rays.size()));
  for (size_t i = first; i < end; ++i)
    addRay(seen_.rays[i], matches_[i], one * gemanMcClureWeight(matches_[i].residual, outlier),
           blocks_[block].sums);
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
