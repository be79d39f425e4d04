#pragma once

#include <vector>

#include "contour/fit/containment.h"
#include "contour/fit/contour_fitter.h"
#include "contour/fit/ray_match.h"
#include "contour/model/normal_equations.h"

namespace markerless_mocap {

/// The fit of one body to one observation: scratch memory, and the normal equations at the last
/// evaluated pose. Blocks of rays and views are summed in parallel; the result does not depend on
/// the number of threads.
class PoseProblem {
 public:
  /// All arguments must outlive this object.
  PoseProblem(const ContourObservation& seen, const CameraRig& rig, const ContourOptions& options)
      : seen_(seen), rig_(rig), options_(options), matches_(seen.rays.size()) {}

  /// Places the body and accumulates rays and containment.
  /// \param outlier scale of the robust loss, metres
  void evaluate(const ContourBody& body, const ContourPose& pose, double outlier);

  const ContourFrames& frames() const { return frames_; }
  const ContourWorldCones& cones() const { return cones_; }
  const AllConeNormalEquations& sums() const { return sums_; }
  const std::vector<RayMatch>& matches() const { return matches_; }
  const SphereViolation& violation() const { return violation_; }

 private:
  struct Block {
    AllConeNormalEquations sums;
    SphereViolation violation{};
  };
  void addRays(const ConesInViews& cones, double outlier, size_t block);
  void addViews(size_t block);

  const ContourObservation& seen_;
  const CameraRig& rig_;
  const ContourOptions& options_;
  ContourFrames frames_;
  ContourWorldCones cones_;
  std::vector<Block> blocks_;
  AllConeNormalEquations sums_;
  std::vector<RayMatch> matches_;
  SphereViolation violation_{};
};

/// Adds the residual of a ray to the cone that it is matched to.
void addRay(const ContourRay& ray, const RayMatch& match, double weight,
            AllConeNormalEquations& sums);

/// Robust scale of a step: a geometric sequence from the initial to the final value.
double robustScaleAt(const RobustSchedule& schedule, int iteration);

}  // namespace markerless_mocap
