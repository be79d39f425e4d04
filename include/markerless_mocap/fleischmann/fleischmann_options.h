#pragma once

#include <string>

#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

/// Settings of the method of Fleischmann (2012).
struct FleischmannOptions {
  static constexpr const char* kStage = "pose_fitting/fleischmann";
  /// how the parameters are searched; annealed_filter, interacting_annealing: particle filters; the
  /// others: a particle swarm, as a whole or in soft or hard partitions (Fleischmann 2012, 6.6)
  std::string search = "two_soft";
  /// factor of the number of particles of every stage
  double particle_factor = 1.0;
  /// particles of the last stage of two_soft
  int final_stage_particles = 20;
  /// iterations of the last stage of two_soft
  int final_stage_iterations = 40;
  /// compare edges, not only silhouettes
  bool use_edges = true;
  /// the upper edge of the torso is one of the edges
  bool use_torso_top_edge = true;
  /// one particle of each swarm stage begins exactly at the start of the search
  bool include_start_particle = true;
  /// fraction of the last change of pose that is added to the last pose to start the search
  double prediction_fraction = 0.0;
  /// factor of the initial spread that the motion statistics give
  double sigma_factor = 1.0;
  /// limbs collide when their axes are closer than this fraction of the sum of their radii
  double collision_fraction = 0.85;
  /// a pose with a lower silhouette fitness is reported as lost
  double min_silhouette_fitness = 0.5;
  /// seed of the random numbers
  int seed = 1;
  FleischmannImageOptions image;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
