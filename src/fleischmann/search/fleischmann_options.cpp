#include "markerless_mocap/fleischmann/fleischmann_options.h"

namespace markerless_mocap {

void FleischmannOptions::visit(OptionVisitor& v) {
  v.field("search", search,
          {"two_soft", "one_global", "two_hard", "three_soft", "twelve_hard", "annealed_filter",
           "interacting_annealing"},
          "how the parameters are searched; annealed_filter, interacting_annealing: particle "
          "filters; the others: a particle swarm, as a whole or in soft or hard partitions "
          "(Fleischmann 2012, 6.6)");
  v.field("particle_factor", particle_factor, 0.1, 100.0,
          "factor of the number of particles of every stage");
  v.field("final_stage_particles", final_stage_particles, 1, 10000,
          "particles of the last stage of two_soft");
  v.field("final_stage_iterations", final_stage_iterations, 1, 10000,
          "iterations of the last stage of two_soft");
  v.field("use_edges", use_edges, "compare edges, not only silhouettes");
  v.field("use_torso_top_edge", use_torso_top_edge,
          "the upper edge of the torso is one of the edges");
  v.field("include_start_particle", include_start_particle,
          "one particle of each swarm stage begins exactly at the start of the search");
  v.field("prediction_fraction", prediction_fraction, 0.0, 1.0,
          "fraction of the last change of pose that is added to the last pose to start the search");
  v.field("sigma_factor", sigma_factor, 0.05, 20.0,
          "factor of the initial spread that the motion statistics give");
  v.field("collision_fraction", collision_fraction, 0.0, 1.0,
          "limbs collide when their axes are closer than this fraction of the sum of their radii");
  v.field("min_silhouette_fitness", min_silhouette_fitness, 0.0, 1.0,
          "a pose with a lower silhouette fitness is reported as lost");
  v.field("seed", seed, 0, 1000000000, "seed of the random numbers");
  image.visit(v);
}

void FleischmannOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
