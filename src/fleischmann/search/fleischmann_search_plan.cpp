#include "fleischmann/search/fleischmann_search_plan.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "optimisation/annealed_filter.h"
#include "optimisation/staged_swarm.h"

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

constexpr double kSettled = 0.1;  // scale of sigma for parameters that an earlier stage has found

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
  explicit Stages(const FleischmannOptions& options) : options_(options) {}

  Stages& add(int particles, int iterations, VectorXd reach, ConeSet edges) {
    const double scaled = particles * options_.particle_factor;
    stages_.push_back({std::max(1, int(std::lround(scaled))), iterations, std::move(reach)});
    edges_.push_back({options_.use_edges ? edges : 0, options_.use_torso_top_edge});
    return *this;
  }
  FleischmannSearchPlan plan() const {
    return {std::make_shared<StagedSwarm>(stages_, options_.include_start_particle), edges_};
  }

 private:
  const FleischmannOptions& options_;
  std::vector<SwarmStage> stages_;
  std::vector<EdgeSelection> edges_;
};

FleischmannSearchPlan twoSoft(const FleischmannOptions& o) {
  VectorXd second = everything();
  second.segment<3>(kPelvisPosition) *= kSettled;
  return Stages(o)
      .add(10, 20, pelvis(), kTorsoOnly)
      .add(o.final_stage_particles, o.final_stage_iterations, second, kAllButHead)
      .plan();
}

FleischmannSearchPlan threeSoft(const FleischmannOptions& o) {
  VectorXd second = everything(), third = everything();
  second.segment<3>(kPelvisPosition) *= kSettled;
  third *= 0.5;
  third.head<6>().setConstant(kSettled);
  for (const int p : kLowerLimbs) {
    second[p] = 0.0;
    third[p] = std::sqrt(2.0);
  }
  return Stages(o)
      .add(10, 20, pelvis(), kTorsoOnly)
      .add(10, 40, second, kTorsoOnly | kUpperLimbs)
      .add(10, 40, third, kAllButHead)
      .plan();
}

/// Position, orientation, spine, each arm above and below the twist of the elbow, head, each leg
/// likewise.
FleischmannSearchPlan twelveHard(const FleischmannOptions& o) {
  Stages stages(o);
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
  settings.particles = std::max(2, int(std::lround(settings.particles * o.particle_factor)));
  return settings;
}

}  // namespace

FleischmannSearchPlan makeSearchPlan(const FleischmannOptions& o) {
  o.validate();
  if (o.search == "two_soft") return twoSoft(o);
  if (o.search == "three_soft") return threeSoft(o);
  if (o.search == "twelve_hard") return twelveHard(o);
  if (o.search == "one_global") return Stages(o).add(25, 40, everything(), kAllButHead).plan();
  if (o.search == "two_hard") {
    VectorXd second = everything();
    second.head<6>().setZero();
    return Stages(o).add(10, 20, pelvis(), kTorsoOnly).add(20, 40, second, kAllButHead).plan();
  }
  FleischmannSearchPlan plan;
  plan.edges = {{o.use_edges ? kAllButHead : 0, o.use_torso_top_edge}};
  if (o.search == "annealed_filter")
    plan.optimiser = std::make_shared<AnnealedParticleFilter>(annealing(o));
  else
    plan.optimiser = std::make_shared<InteractingAnnealing>(annealing(o));
  return plan;
}

}  // namespace markerless_mocap
