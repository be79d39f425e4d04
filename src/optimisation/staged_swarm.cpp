#include "optimisation/staged_swarm.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "numerics/counter_random.h"
#include "optimisation/detail/swarm.h"

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

// Number of particles that one task moves and evaluates.
constexpr int kBatch = 3;

/// The search of one stage.
class StageSearch {
 public:
  StageSearch(const SearchProblem& problem, const SwarmStage& stage, int index,
              const SearchStart& start, const CounterRandom& random,
              const StagedSwarmSettings& settings)
      : problem_(problem),
        stage_(stage),
        index_(index),
        start_(start),
        random_(random),
        settings_(settings),
        swarm_(start.center, stage.particles),
        rejected_moves_(Eigen::VectorXi::Zero(stage.particles)) {}

  SearchOutcome run() {
    swarm_.step(problem_, index_, kBatch, [this](int i) { scatter(i); });
    watch();
    for (int k = 1; k < stage_.iterations; ++k) {
      const double acceleration = settings_.initial_acceleration +
                                  (settings_.final_acceleration - settings_.initial_acceleration) *
                                      k / std::max(1, stage_.iterations - 1);
      const CounterRandom random = random_.stream(uint64_t(k));
      swarm_.step(problem_, index_, kBatch,
                  [&](int i) { move(i, acceleration, random.stream(uint64_t(i))); });
      watch();
    }
    swarm_.outcome.rejected_moves = rejected_moves_.sum();
    return swarm_.outcome;
  }

 private:
  void watch() const {
    if (settings_.watch) settings_.watch(index_, swarm_.position);
  }

  void scatter(int i) {
    const CounterRandom random = random_.stream(0).stream(uint64_t(i));
    const auto dimensions = start_.center.size();
    const bool drawn = drawFeasible(
        problem_, start_.center,
        [&](int attempt, Eigen::Ref<VectorXd> candidate) {
          const double scale = settings_.keep_center && i == 0 && attempt == 0 ? 0.0 : 1.0;
          for (Eigen::Index d = 0; d < dimensions; ++d)
            candidate[d] = start_.center[d] + scale * start_.sigma[d] *
                                                  random.normal(uint64_t(attempt * dimensions + d));
        },
        swarm_.position.col(i));
    rejected_moves_[i] += !drawn;
    const CounterRandom velocities = random.stream(1);
    for (Eigen::Index d = 0; d < dimensions; ++d)
      swarm_.velocity(d, i) = velocities.between(-start_.sigma[d], start_.sigma[d], uint64_t(d));
  }

  /// Eq. 5.8 with a limited velocity; drawn again from the same position until the result is
  /// feasible.
  void move(int i, double acceleration, const CounterRandom& random) {
    const auto dimensions = start_.center.size();
    const double chi = constriction(2.0 * acceleration);
    const VectorXd from = swarm_.position.col(i), velocity = swarm_.velocity.col(i);
    const bool drawn = drawFeasible(
        problem_, from,
        [&](int attempt, Eigen::Ref<VectorXd> candidate) {
          for (Eigen::Index d = 0; d < dimensions; ++d) {
            const uint64_t counter = uint64_t(2 * (attempt * dimensions + d));
            const double v =
                chi *
                (velocity[d] +
                 acceleration * random.uniform(counter) * (swarm_.personal_best(d, i) - from[d]) +
                 acceleration * random.uniform(counter + 1) * (swarm_.globalBest()[d] - from[d]));
            const double most = settings_.max_velocity * start_.sigma[d];
            candidate[d] = from[d] + std::min(std::max(v, -most), most);
          }
        },
        swarm_.position.col(i));
    rejected_moves_[i] += !drawn;
    swarm_.velocity.col(i) = swarm_.position.col(i) - from;
  }

  const SearchProblem& problem_;
  const SwarmStage& stage_;
  int index_;
  const SearchStart& start_;
  CounterRandom random_;
  const StagedSwarmSettings& settings_;
  Swarm swarm_;
  Eigen::VectorXi rejected_moves_;
};

}  // namespace

double constriction(double phi) {
  return 2.0 / std::abs(2.0 - phi - std::sqrt(phi * phi - 4.0 * phi));
}

StagedSwarm::StagedSwarm(std::vector<SwarmStage> stages, StagedSwarmSettings settings)
    : stages_(std::move(stages)), settings_(std::move(settings)) {
  if (!(settings_.initial_acceleration > 2.0 && settings_.final_acceleration > 2.0))
    throw std::invalid_argument("the accelerations of a staged swarm must be above 2");
  if (stages_.empty()) throw std::invalid_argument("a staged swarm needs at least one stage");
  for (size_t i = 0; i < stages_.size(); ++i) {
    const SwarmStage& stage = stages_[i];
    const std::string name = "swarm stage " + std::to_string(i);
    if (stage.particles < 1 || stage.iterations < 1)
      throw std::invalid_argument(name + " needs at least one particle and one iteration");
    if (stage.sigma_scale.size() != stages_.front().sigma_scale.size() ||
        !stage.sigma_scale.allFinite() || (stage.sigma_scale.array() < 0.0).any())
      throw std::invalid_argument(name + " needs a reach of at least 0 for each parameter");
  }
}

int StagedSwarm::evaluations() const {
  int sum = 0;
  for (const SwarmStage& stage : stages_) sum += stage.particles * stage.iterations;
  return sum;
}

SearchOutcome StagedSwarm::minimise(const SearchProblem& problem, const SearchStart& start,
                                    uint64_t seed) const {
  validateProblem(problem, start);
  if (stages_.front().sigma_scale.size() != start.center.size())
    throw std::invalid_argument("a staged swarm for " +
                                std::to_string(stages_.front().sigma_scale.size()) +
                                " parameters cannot search " + std::to_string(start.center.size()));
  const CounterRandom random(seed);
  SearchOutcome all;
  all.best = start.center;
  for (size_t i = 0; i < stages_.size(); ++i) {
    const SearchStart here = {all.best, start.sigma.cwiseProduct(stages_[i].sigma_scale)};
    const SearchOutcome found =
        StageSearch(problem, stages_[i], int(i), here, random.stream(i), settings_).run();
    all.evaluations += found.evaluations;
    all.rejected_moves += found.rejected_moves;
    all.found = found.found;
    all.cost = found.cost;
    if (found.found) all.best = found.best;
  }
  return all;
}

}  // namespace markerless_mocap
