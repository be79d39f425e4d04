#pragma once

#include <array>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

constexpr int kHsiaoAngles = 16;

/// Ranges of the sixteen angles. Equal ends hold a joint still.
struct HsiaoLimits {
  std::array<double, kHsiaoAngles> lower, upper;  ///< radians, by k - 1
  /// Hsiao 2008, Table 3-4.
  static HsiaoLimits thesis();
};

/// Settings of the pose fitting stage.
struct FittingOptions {
  static constexpr const char* kStage = "pose_fitting";
  int seed = 1;
  int curve_samples = 16;
  double particles_per_parameter = 2.0;
  double iterations_per_parameter = 1.5;
  int tune_particles = 16;
  int tune_iterations = 16;
  int spin_starts = 2;
  int start_attempts = 3;
  int refine_iterations = 10;
  int surface_points = 600;
  double highest_speed = 3.0;
  double highest_turn_rate = 12.0;
  double reset_threshold = 0.015;
  double highest_error = 0.085;
  double highest_limb_error = 0.20;
  double explained_margin = 0.04;
  double least_hull_explained = 0.75;
  double least_body_in_hull = 0.65;
  double memory = 0.3;
  HsiaoLimits limits = HsiaoLimits::thesis();

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
