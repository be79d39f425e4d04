#pragma once

#include <vector>

#include "contour/fit/containment.h"
#include "contour/fit/contour_fitter.h"
#include "contour/fit/ray_match.h"
#include "contour/model/normal_equations.h"

namespace markerless_mocap {

/// One body before one instant's contours: scratch memory and the sums at the last pose.
class PoseProblem {
 public:
  /// All given must outlive it.
  PoseProblem(const ContourObservation& seen, const CameraRig& rig, const ContourOptions& options)
      : seen_(seen), rig_(rig), options_(options) {}

  /// Places the body and sums up rays and containment.
  /// \param outlier distance from which on a ray is mostly ignored, metres
  void evaluate(const ContourBody& body, const ContourPose& pose, double outlier);

  const ContourFrames& frames() const { return frames_; }
  const ContourWorldCones& cones() const { return cones_; }
  const AllConeNormalEquations& sums() const { return sums_; }
  const std::vector<RayMatch>& matches() const { return matches_; }
  const SphereViolation& excess() const { return excess_; }

 private:
  void addRays(double outlier);

  const ContourObservation& seen_;
  const CameraRig& rig_;
  const ContourOptions& options_;
  ContourFrames frames_;
  ContourWorldCones cones_;
  AllConeNormalEquations sums_;
  std::vector<RayMatch> matches_;
  SphereViolation excess_{};
};

/// Adds what a ray tells of the cone it is matched to.
void addRay(const ContourRay& ray, const RayMatch& match, double weight,
            AllConeNormalEquations& sums);

/// Robustness of a step, from the first value to the last by equal factors.
double robustScaleAt(const RobustSchedule& schedule, int iteration);

}  // namespace markerless_mocap
