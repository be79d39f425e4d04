#pragma once

#include <array>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

constexpr int kHsiaoAngles = 16;

/// Ranges of the sixteen angles. Equal ends hold a joint still.
struct HsiaoLimits {
  std::array<double, kHsiaoAngles> lower, upper;  ///< radians, by k - 1
  /// Hsiao 2008, Table 3-4.
  static HsiaoLimits fromThesis();
};

/// Settings of the pose fitting stage.
struct HsiaoOptions {
  static constexpr const char* kStage = "pose_fitting";
  int seed = 1;
  int curve_samples = 16;
  double particles_per_parameter = 2.0;
  double iterations_per_parameter = 1.5;
  int fine_tune_particles = 16;
  int fine_tune_iterations = 16;
  int initial_headings = 2;
  int initialization_attempts = 3;
  int refinement_iterations = 10;
  int refinement_surface_points = 600;
  double max_root_speed = 3.0;
  double max_joint_velocity = 12.0;
  double reset_threshold = 0.015;
  double max_skeleton_error = 0.085;
  double max_limb_error = 0.20;
  double hull_margin = 0.04;
  double min_hull_explained = 0.75;
  double min_body_in_hull = 0.65;
  double max_pose_age = 0.3;
  HsiaoLimits limits = HsiaoLimits::fromThesis();

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
