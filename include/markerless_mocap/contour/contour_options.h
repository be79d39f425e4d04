#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the fit of a body to silhouettes' contours.
struct ContourOptions {
  static constexpr const char* kStage = "pose_fitting/contour";
  /// number of points on the borders of the silhouettes, over all cameras, that the body is fitted
  /// to
  int rays = 1500;
  /// damped Gauss-Newton steps per frame at 15 Hz and less; down to half of them at higher rates
  int iterations = 8;
  /// standard deviation of the distance between viewing ray and body, m
  double ray_sigma = 0.012;
  /// number of independent rays that all rays together count as
  double effective_rays = 450.0;
  /// weight of one sphere of the body that leaves one silhouette, in rays
  double containment_weight = 0.2;
  /// distance of a ray from the body above which it has little weight, in the first step, m
  double robust_scale_initial = 0.08;
  /// the same distance in the last step, m; at most robust_scale_initial
  double robust_scale_final = 0.03;
  /// standard deviation of the velocity of a joint about its prediction, rad/s
  double joint_velocity_sigma = 6.0;
  /// standard deviation of the velocity of the body about its prediction, m/s
  double root_velocity_sigma = 1.5;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
