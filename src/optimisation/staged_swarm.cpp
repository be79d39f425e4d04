#include "optimisation/staged_swarm.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "numerics/counter_random.h"

namespace markerless_mocap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double kInitialAcceleration = 2.05, kFinalAcceleration = 2.15;
constexpr double kMaxVelocity = 2.0;  // sigmas per iteration
// Particles that one task moves and judges.
constexpr int kBatch = 3;

/// One stage's search.
class Swarm {
 public:
  Swarm(const SearchProblem& problem, const SwarmStage& stage, int index, const SearchStart& start,
        const CounterRandom& random, bool keep_center)
      : problem_(problem),
        stage_(stage),
        index_(index),
        start_(start),
        random_(random),
        keep_center_(keep_center),
        position_(start.center.size(), stage.particles),
        velocity_(start.center.size(), stage.particles),
        personal_best_(start.center.size(), stage.particles),
        cost_(stage.particles),
        personal_best_cost_(VectorXd::Constant(stage.particles, HUGE_VAL)),
        rejected_moves_(Eigen::VectorXi::Zero(stage.particles)) {
    result_.best = start.center;
    result_.cost = HUGE_VAL;
  }

  SearchOutcome run() {
    forEachParticle([this](int i) { scatter(i); });
    for (int k = 1; k < stage_.iterations; ++k) {
      const double acceleration =
          kInitialAcceleration +
          (kFinalAcceleration - kInitialAcceleration) * k / std::max(1, stage_.iterations - 1);
      const CounterRandom random = random_.stream(uint64_t(k));
      forEachParticle([&](int i) { move(i, acceleration, random.stream(uint64_t(i))); });
    }
    result_.evaluations = stage_.particles * stage_.iterations;
    result_.rejected_moves = rejected_moves_.sum();
    return result_;
  }

 private:
  /// Places and judges all particles, then remembers the best. Remembering is serial, so that ties
  /// fall the same way whatever the number of threads.
  template <class Place>
  void forEachParticle(const Place& place) {
    tbb::parallel_for(tbb::blocked_range<int>(0, stage_.particles, kBatch),
                      [&](const tbb::blocked_range<int>& r) {
                        for (int i = r.begin(); i < r.end(); ++i) place(i);
                        problem_.cost(index_, position_.col(r.begin()).data(), int(r.size()),
                                      cost_.data() + r.begin());
                      });
    for (int i = 0; i < stage_.particles; ++i) {
      if (!std::isfinite(cost_[i])) continue;
      result_.found = true;
      if (cost_[i] < personal_best_cost_[i]) {
        personal_best_cost_[i] = cost_[i];
        personal_best_.col(i) = position_.col(i);
      }
      if (cost_[i] < result_.cost) {
        result_.cost = cost_[i];
        result_.best = position_.col(i);
      }
    }
  }

  void scatter(int i) {
    const CounterRandom random = random_.stream(0).stream(uint64_t(i));
    const auto dimensions = position_.rows();
    const bool drawn = drawFeasible(
        problem_, start_.center,
        [&](int attempt, Eigen::Ref<VectorXd> candidate) {
          const double scale = keep_center_ && i == 0 && attempt == 0 ? 0.0 : 1.0;
          for (Eigen::Index d = 0; d < dimensions; ++d)
            candidate[d] = start_.center[d] + scale * start_.sigma[d] *
                                                  random.normal(uint64_t(attempt * dimensions + d));
        },
        position_.col(i));
    rejected_moves_[i] += !drawn;
    const CounterRandom velocities = random.stream(1);
    for (Eigen::Index d = 0; d < dimensions; ++d)
      velocity_(d, i) = velocities.between(-start_.sigma[d], start_.sigma[d], uint64_t(d));
    personal_best_.col(i) = position_.col(i);
  }

  /// Eq. 5.8 with the velocity limited, drawn anew from the same place until it is allowed.
  void move(int i, double acceleration, const CounterRandom& random) {
    const auto dimensions = position_.rows();
    const double chi = constriction(2.0 * acceleration);
    const VectorXd from = position_.col(i), velocity = velocity_.col(i);
    const bool drawn = drawFeasible(
        problem_, from,
        [&](int attempt, Eigen::Ref<VectorXd> candidate) {
          for (Eigen::Index d = 0; d < dimensions; ++d) {
            const uint64_t counter = uint64_t(2 * (attempt * dimensions + d));
            const double v =
                chi * (velocity[d] +
                       acceleration * random.uniform(counter) * (personal_best_(d, i) - from[d]) +
                       acceleration * random.uniform(counter + 1) * (result_.best[d] - from[d]));
            const double most = kMaxVelocity * start_.sigma[d];
            candidate[d] = from[d] + std::min(std::max(v, -most), most);
          }
        },
        position_.col(i));
    rejected_moves_[i] += !drawn;
    velocity_.col(i) = position_.col(i) - from;
  }

  const SearchProblem& problem_;
  const SwarmStage& stage_;
  int index_;
  const SearchStart& start_;
  CounterRandom random_;
  bool keep_center_;
  MatrixXd position_, velocity_, personal_best_;  // a particle is a column
  VectorXd cost_, personal_best_cost_;
  Eigen::VectorXi rejected_moves_;
  SearchOutcome result_;
};

}  // namespace

double constriction(double phi) {
  return 2.0 / std::abs(2.0 - phi - std::sqrt(phi * phi - 4.0 * phi));
}

StagedSwarm::StagedSwarm(std::vector<SwarmStage> stages, bool keep_center)
    : stages_(std::move(stages)), keep_center_(keep_center) {
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
        Swarm(problem, stages_[i], int(i), here, random.stream(i), keep_center_).run();
    all.evaluations += found.evaluations;
    all.rejected_moves += found.rejected_moves;
    all.found = found.found;
    all.cost = found.cost;
    if (found.found) all.best = found.best;
  }
  return all;
}

}  // namespace markerless_mocap
