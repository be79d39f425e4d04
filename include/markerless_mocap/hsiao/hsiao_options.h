#pragma once

#include <array>

#include "markerless_mocap/options/options.h"

namespace markerless_mocap {

constexpr int kHsiaoAngles = 16;

/// Ranges of the sixteen angles. If minimum and maximum are equal, the joint does not move.
struct HsiaoLimits {
  /// smallest and largest angle, rad; equal: the joint does not move
  std::array<double, kHsiaoAngles> lower, upper;
  /// Hsiao 2008, Table 3-4.
  static HsiaoLimits fromThesis();

  void visit(OptionVisitor& v);
};

/// Settings of the method of Hsiao (2008).
struct HsiaoOptions {
  static constexpr const char* kStage = "pose_fitting/hsiao";
  /// seed of the random numbers
  int seed = 1;
  /// how the swarms are staged; guided: arms and legs are first fitted alone, the facing directions
  /// are given by the limbs, and the last pose is followed in one stage; published: the stages of
  /// Hsiao 2008, Table 3-3 only, with the spin searched from stage 2 on, also around the last pose
  std::string search = "guided";
  /// how part curves are compared with the model; aligned: from the outer end of each limb, with
  /// parts of the same kind; published: the whole curve with the whole part, any part with any
  /// (Hsiao 2008, Eq. 3-27)
  std::string part_error = "aligned";
  /// refine and judge poses by the hull, too; false: by the part curves alone, as in Hsiao 2008
  bool use_hull = true;
  /// number of points compared along each part curve
  int samples_per_curve = 16;
  /// particles of a swarm stage per parameter that it searches
  double particles_per_parameter = 2.0;
  /// iterations of a swarm stage per parameter that it searches
  double iterations_per_parameter = 1.5;
  /// particles when one part is fine-tuned
  int fine_tune_particles = 16;
  /// iterations when one part is fine-tuned
  int fine_tune_iterations = 16;
  /// t1 of Hsiao 2008, 3.2.2.2: part of its velocity that a particle keeps
  double inertia = 0.6;
  /// t2: pull towards the particle's own best position
  double cognitive_weight = 1.5;
  /// t3: pull towards the best position of all particles
  double social_weight = 1.5;
  /// number of facing directions tried; 2: as left and right of the limbs say, and the reverse
  int initial_headings = 2;
  /// number of searches with different seeds at a start; the method contour uses one
  int initialization_attempts = 3;
  /// steps of the final refinement by curves and hull
  int refinement_iterations = 10;
  /// number of surface voxels of the hull that the refinement uses
  int refinement_surface_points = 600;
  /// largest speed of the trunk in the temporal search, m/s
  double max_root_speed = 3.0;
  /// largest rate of change of a joint angle in the temporal search, rad/s
  double max_joint_velocity = 12.0;
  /// the temporal pose is dropped when its error exceeds the basic search's by this, m
  double reset_threshold = 0.015;
  /// a pose with a larger skeleton error is reported as lost, m
  double max_skeleton_error = 0.085;
  /// a limb with a larger error counts as not seen, m
  double max_limb_error = 0.20;
  /// distance from the body up to which a hull voxel counts as explained, m
  double hull_margin = 0.04;
  /// fraction of the hull that the body must explain
  double min_hull_explained = 0.75;
  /// fraction of the body's volume that must be in the hull
  double min_body_in_hull = 0.65;
  /// time for which the last pose guides the search, s
  double max_pose_age = 0.3;
  /// range of each joint angle (defaults: Hsiao 2008, Table 3-4), [min, max], rad
  HsiaoLimits joint_limits = HsiaoLimits::fromThesis();

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
