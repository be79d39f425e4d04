#include "markerless_mocap/fleischmann/fleischmann_options.h"

namespace markerless_mocap {

void FleischmannBodyOptions::visit(OptionVisitor& v) {
  v.field("lower_limb_length", lower_limb_length, 0.5, 2.0,
          "length of calves and lower arms relative to the bones, to cover heels and wrists "
          "(Fleischmann 2012, 5.1.2)");
  v.field("thigh_width", thigh_width, 0.5, 2.0,
          "thickness of the thighs relative to the person's, for loose shorts (Fleischmann 2012, "
          "5.1.2)");
  v.field("joint_limits", joint_limits, {"walking", "full"},
          "range of the joint angles; walking: of people who stand, walk and reach; full: what "
          "adults can do");
  v.field("collision_pairs", collision_pairs, {"limbs", "all"},
          "cones that may not penetrate each other; limbs: those of limbs that meet when people "
          "walk; all: each two that share no joint");
  v.field("collision_fraction", collision_fraction, 0.0, 1.0,
          "limbs collide when their axes are closer than this fraction of the sum of their radii");
}

void FleischmannBodyOptions::validate() const {
  checkFields(*this);
}

void FleischmannSwarmOptions::visit(OptionVisitor& v) {
  v.field("first_stage_particles", first_stage_particles, 1, 10000,
          "particles of the first stage of two_soft and three_soft");
  v.field("first_stage_iterations", first_stage_iterations, 1, 10000,
          "iterations of the first stage of two_soft and three_soft");
  v.field("final_stage_particles", final_stage_particles, 1, 10000,
          "particles of the last stage of two_soft");
  v.field("final_stage_iterations", final_stage_iterations, 1, 10000,
          "iterations of the last stage of two_soft");
  v.field("settled_spread", settled_spread, 0.0, 1.0,
          "factor of the spread of the position after the first soft stage (Fleischmann 2012, "
          "5.3.3)");
  v.field("initial_acceleration", initial_acceleration, 2.001, 10.0,
          "c1 and c2 at a swarm's first iteration (Fleischmann 2012, 5.3.2)");
  v.field("final_acceleration", final_acceleration, 2.001, 10.0,
          "c1 and c2 at a swarm's last iteration (Fleischmann 2012, 5.3.2)");
  v.field("max_velocity", max_velocity, 0.01, 1000.0,
          "largest velocity of a particle, initial spreads per iteration (Fleischmann 2012, "
          "5.3.2)");
  v.field("draw_attempts", draw_attempts, 1, 1000,
          "how often a move is drawn again that leaves the joint limits or lets limbs collide");
  v.field("filter_particles", filter_particles, 2, 100000,
          "particles of annealed_filter and interacting_annealing");
  v.field("filter_layers", filter_layers, 1, 1000,
          "layers of annealed_filter and interacting_annealing");
  v.field("survival_rate", survival_rate, 0.01, 1.0,
          "fraction of the particles of annealed_filter that survive a layer");
  v.field("crossover", crossover, 0.0, 1.0,
          "probability that a particle of annealed_filter takes a range of its parameters from a "
          "second survivor (Deutscher and Reid 2005)");
  v.field("carry_particles", carry_particles,
          "annealed_filter starts with the particles of the last frame, not with its pose alone");
}

void FleischmannSwarmOptions::validate() const {
  checkFields(*this);
}

void FleischmannOptions::visit(OptionVisitor& v) {
  v.field("search", search,
          {"two_soft", "one_global", "two_hard", "three_soft", "twelve_hard", "annealed_filter",
           "interacting_annealing"},
          "how the parameters are searched; annealed_filter, interacting_annealing: particle "
          "filters; the others: a particle swarm, as a whole or in soft or hard partitions "
          "(Fleischmann 2012, 6.6)");
  v.field("particle_factor", particle_factor, 0.1, 100.0,
          "factor of the number of particles of every stage");
  v.field("use_edges", use_edges, "compare edges, not only silhouettes");
  v.field("use_torso_top_edge", use_torso_top_edge,
          "the upper edge of the torso is one of the edges");
  v.field("include_start_particle", include_start_particle,
          "one particle of each swarm stage begins exactly at the start of the search");
  v.field("prediction_fraction", prediction_fraction, 0.0, 1.0,
          "fraction of the last change of pose that is added to the last pose to start the search");
  v.field("sigma_factor", sigma_factor, 0.05, 20.0,
          "factor of the initial spread that the motion statistics give");
  v.field("min_silhouette_fitness", min_silhouette_fitness, 0.0, 1.0,
          "a pose with a lower silhouette fitness is reported as lost");
  v.field("max_pose_age", max_pose_age, 0.05, 1e6,
          "a pose that is older is not searched around, s");
  v.field("reconsider", reconsider,
          "where the fitness falls, compare the pose with one that the initializer proposes");
  v.field("seed", seed, 0, 1000000000, "seed of the random numbers");
  swarm.visit(v);
  body.visit(v);
  image.visit(v);
}

void FleischmannOptions::validate() const {
  checkFields(*this);
}

}  // namespace markerless_mocap
