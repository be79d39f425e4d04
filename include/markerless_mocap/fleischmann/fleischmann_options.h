#pragma once

#include <string>

#include "markerless_mocap/fleischmann/fleischmann_image_options.h"

namespace markerless_mocap {

/// The body of the method of Fleischmann (2012).
struct FleischmannBodyOptions {
  static constexpr const char* kStage = "pose_fitting/fleischmann";
  /// length of calves and lower arms relative to the bones, to cover heels and wrists (Fleischmann
  /// 2012, 5.1.2)
  double lower_limb_length = 1.2;
  /// thickness of the thighs relative to the person's, for loose shorts (Fleischmann 2012, 5.1.2)
  double thigh_width = 1.0;
  /// range of the joint angles; walking: of people who stand, walk and reach; full: what adults can
  /// do
  std::string joint_limits = "walking";
  /// cones that may not penetrate each other; limbs: those of limbs that meet when people walk;
  /// all: each two that share no joint
  std::string collision_pairs = "limbs";
  /// limbs collide when their axes are closer than this fraction of the sum of their radii
  double collision_fraction = 0.85;

  void visit(OptionVisitor& v);
  void validate() const;
};

/// The swarms and filters of the method of Fleischmann (2012).
struct FleischmannSwarmOptions {
  static constexpr const char* kStage = "pose_fitting/fleischmann";
  /// particles of the first stage of two_soft and three_soft
  int first_stage_particles = 10;
  /// iterations of the first stage of two_soft and three_soft
  int first_stage_iterations = 20;
  /// particles of the last stage of two_soft
  int final_stage_particles = 20;
  /// iterations of the last stage of two_soft
  int final_stage_iterations = 40;
  /// factor of the spread of the position after the first soft stage (Fleischmann 2012, 5.3.3)
  double settled_spread = 0.1;
  /// c1 and c2 at a swarm's first iteration (Fleischmann 2012, 5.3.2)
  double initial_acceleration = 2.05;
  /// c1 and c2 at a swarm's last iteration (Fleischmann 2012, 5.3.2)
  double final_acceleration = 2.15;
  /// largest velocity of a particle, initial spreads per iteration (Fleischmann 2012, 5.3.2)
  double max_velocity = 2.0;
  /// how often a move is drawn again that leaves the joint limits or lets limbs collide
  int draw_attempts = 10;
  /// particles of annealed_filter and interacting_annealing
  int filter_particles = 200;
  /// layers of annealed_filter and interacting_annealing
  int filter_layers = 5;
  /// fraction of the particles of annealed_filter that survive a layer
  double survival_rate = 0.5;
  /// probability that a particle of annealed_filter takes a range of its parameters from a second
  /// survivor (Deutscher and Reid 2005)
  double crossover = 0.0;
  /// annealed_filter starts with the particles of the last frame, not with its pose alone
  bool carry_particles = false;

  void visit(OptionVisitor& v);
  void validate() const;
};

/// Settings of the method of Fleischmann (2012).
struct FleischmannOptions {
  static constexpr const char* kStage = "pose_fitting/fleischmann";
  /// how the parameters are searched; annealed_filter, interacting_annealing: particle filters; the
  /// others: a particle swarm, as a whole or in soft or hard partitions (Fleischmann 2012, 6.6)
  std::string search = "two_soft";
  /// factor of the number of particles of every stage
  double particle_factor = 1.0;
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
  /// a pose with a lower silhouette fitness is reported as lost
  double min_silhouette_fitness = 0.5;
  /// a pose that is older is not searched around, s
  double max_pose_age = 0.5;
  /// where the fitness falls, compare the pose with one that the initializer proposes
  bool reconsider = true;
  /// seed of the random numbers
  int seed = 1;
  FleischmannSwarmOptions swarm;
  FleischmannBodyOptions body;
  FleischmannImageOptions image;

  void visit(OptionVisitor& v);
  void validate() const;
};

}  // namespace markerless_mocap
