#include "markerless_mocap/fleischmann/fleischmann_options.h"

namespace markerless_mocap {

void FleischmannOptions::visit(OptionVisitor& v) {
  v.field("search", search,
          {"two_soft", "one_global", "two_hard", "three_soft", "twelve_hard", "annealed_filter",
           "interacting_annealing"},
          "how the parameters are searched: partitions of the swarm, or a rival");
  v.field("particle_factor", particle_factor, 0.1, 100.0, "factor of the particles of all stages");
  v.field("final_stage_particles", final_stage_particles, 1, 10000,
          "particles of the last of two_soft's stages");
  v.field("final_stage_iterations", final_stage_iterations, 1, 10000,
          "iterations of the last of two_soft's stages");
  v.field("edges", edges, "edges count beside silhouettes");
  v.field("torso_top", torso_top, "the torso's upper edge counts among the edges");
  v.field("include_start_particle", include_start_particle,
          "one particle of each swarm stage begins at the start itself, not near it");
  v.field("prediction", prediction, 0.0, 1.0,
          "share of the last change of pose that the search's start goes on by");
  v.field("sigma_factor", sigma_factor, 0.05, 20.0,
          "factor of the spread that the motion statistics give");
  v.field("collision", collision, 0.0, 1.0,
          "limbs whose axes come nearer than this share of their radii's sum collide");
  v.field("min_silhouette_fitness", min_silhouette_fitness, 0.0, 1.0,
          "silhouette fitness below which a pose is not claimed");
  v.field("seed", seed, 0, 1000000000, "start of the random numbers");
  appearance.visit(v);
}

void FleischmannOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
