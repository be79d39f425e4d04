#include "fleischmann/search/fleischmann_search_plan.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "optimisation/annealed_filter.h"
#include "optimisation/staged_swarm.h"

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

/// Lower limbs and the twists that move them, in Fleischmann's order (Fleischmann 2012, 6.6).
constexpr int kLowerLimbs[] = {kLeftHip + 2,      kLeftKnee,  kRightHip + 2,      kRightKnee,
                               kLeftShoulder + 2, kLeftElbow, kRightShoulder + 2, kRightElbow};
constexpr ConeSet kUpperLimbs = coneBit(kLeftThighCone) | coneBit(kRightThighCone) |
                                coneBit(kLeftUpperArmCone) | coneBit(kRightUpperArmCone);

VectorXd nothing() {
  return VectorXd::Zero(kFleischmannParameterCount);
}

VectorXd everything() {
  VectorXd reach = VectorXd::Ones(kFleischmannParameterCount);
  reach[kHeadTwist] = 0.0;
  return reach;
}

VectorXd pelvis() {
  VectorXd reach = nothing();
  reach.head<6>().setOnes();
  return reach;
}

VectorXd only(std::initializer_list<int> parameters) {
  VectorXd reach = nothing();
  for (const int p : parameters) reach[p] = 1.0;
  return reach;
}

/// Builds a plan.
class Stages {
 public:
  Stages(const FleischmannOptions& options, const SwarmWatch& watch)
      : options_(options), watch_(watch) {}

  Stages& add(int particles, int iterations, VectorXd reach, ConeSet edges) {
    const double scaled = particles * options_.particle_factor;
    stages_.push_back({std::max(1, int(std::lround(scaled))), iterations, std::move(reach)});
    edges_.push_back({options_.use_edges ? edges : 0, options_.use_torso_top_edge});
    return *this;
  }
  /// The stage that finds orientation and position.
  Stages& addPelvis() {
    return add(options_.swarm.first_stage_particles, options_.swarm.first_stage_iterations,
               pelvis(), kTorsoOnly);
  }
  FleischmannSearchPlan plan() const {
    const FleischmannSwarmOptions& swarm = options_.swarm;
    return {std::make_shared<StagedSwarm>(
                stages_,
                StagedSwarmSettings{options_.include_start_particle, swarm.initial_acceleration,
                                    swarm.final_acceleration, swarm.max_velocity, watch_}),
            edges_};
  }

 private:
  const FleischmannOptions& options_;
  const SwarmWatch& watch_;
  std::vector<SwarmStage> stages_;
  std::vector<EdgeSelection> edges_;
};

FleischmannSearchPlan twoSoft(const FleischmannOptions& o, Stages stages) {
  VectorXd second = everything();
  second.segment<3>(kPelvisPosition) *= o.swarm.settled_spread;
  return stages.addPelvis()
      .add(o.swarm.final_stage_particles, o.swarm.final_stage_iterations, second, kAllButHead)
      .plan();
}

/// Table 6.3 and the factors of sigma before it.
FleischmannSearchPlan threeSoft(const FleischmannOptions& o, Stages stages) {
  VectorXd second = everything(), third = everything();
  second.segment<3>(kPelvisPosition) *= o.swarm.settled_spread;
  third *= 0.5;
  third.head<6>().setConstant(o.swarm.settled_spread);
  for (const int p : kLowerLimbs) {
    second[p] = 0.0;
    third[p] = std::sqrt(2.0);
  }
  return stages.addPelvis()
      .add(10, 40, second, kTorsoOnly | kUpperLimbs)
      .add(10, 40, third, kAllButHead)
      .plan();
}

/// Position, orientation, spine, each arm above and below the twist of the elbow, head, each leg
/// likewise.
FleischmannSearchPlan twelveHard(Stages stages) {
  const auto add = [&](std::initializer_list<int> parameters) {
    stages.add(10, 60, only(parameters), kAllButHead);
  };
  add({3, 4, 5});
  add({0, 1, 2});
  add({kSpine, kSpine + 1});
  add({kLeftClavicle, kLeftClavicle + 1, kLeftShoulder, kLeftShoulder + 1});
  add({kLeftShoulder + 2, kLeftElbow});
  add({kRightClavicle, kRightClavicle + 1, kRightShoulder, kRightShoulder + 1});
  add({kRightShoulder + 2, kRightElbow});
  add({kHeadTurn, kHeadTurn + 1});
  add({kLeftHip, kLeftHip + 1});
  add({kLeftHip + 2, kLeftKnee});
  add({kRightHip, kRightHip + 1});
  add({kRightHip + 2, kRightKnee});
  return stages.plan();
}

AnnealingSettings annealing(const FleischmannOptions& o) {
  AnnealingSettings settings;
  settings.particles = std::max(2, int(std::lround(o.swarm.filter_particles * o.particle_factor)));
  settings.layers = o.swarm.filter_layers;
  settings.survival_rate = o.swarm.survival_rate;
  settings.crossover = o.swarm.crossover;
  return settings;
}

/// One stage as the second one of the others, and two of which the second holds the pelvis.
FleischmannSearchPlan oneGlobal(Stages stages) {
  return stages.add(25, 40, everything(), kAllButHead).plan();
}

FleischmannSearchPlan twoHard(Stages stages) {
  VectorXd second = everything();
  second.head<6>().setZero();
  return stages.addPelvis().add(20, 40, second, kAllButHead).plan();
}

}  // namespace

FleischmannSearchPlan makeSearchPlan(const FleischmannOptions& o, const SwarmWatch& watch) {
  o.validate();
  const Stages stages(o, watch);
  if (o.search == "two_soft") return twoSoft(o, stages);
  if (o.search == "three_soft") return threeSoft(o, stages);
  if (o.search == "twelve_hard") return twelveHard(stages);
  if (o.search == "one_global") return oneGlobal(stages);
  if (o.search == "two_hard") return twoHard(stages);
  FleischmannSearchPlan plan;
  plan.edges = {{o.use_edges ? kAllButHead : 0, o.use_torso_top_edge}};
  if (o.search == "annealed_filter")
    plan.optimiser = std::make_shared<AnnealedParticleFilter>(annealing(o));
  else
    plan.optimiser = std::make_shared<InteractingAnnealing>(annealing(o));
  return plan;
}

}  // namespace markerless_mocap
