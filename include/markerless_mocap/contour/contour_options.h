#pragma once

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

/// Settings of the fit of a body to silhouettes' contours.
struct ContourOptions {
  static constexpr const char* kStage = "contour_fitting";
  int rays = 1500;
  int iterations = 8;
  double sigma = 0.012;
  double effective_rays = 450.0;
  double containment_weight = 0.2;
  double robust_scale_initial = 0.08;
  double robust_scale_final = 0.03;
  double joint_velocity_sigma = 6.0;
  double root_velocity_sigma = 1.5;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
