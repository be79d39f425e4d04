#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <cmath>

#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// Sets the candidates, the columns of `positions`, with `place(i)` and computes their costs.
/// \param batch number of candidates per task
template <class PlaceT>
void evaluateInBatches(const SearchProblem& problem, int stage, int batch, const PlaceT& place,
                       Eigen::MatrixXd& positions, Eigen::VectorXd& costs) {
  tbb::parallel_for(tbb::blocked_range<int>(0, int(positions.cols()), batch),
                    [&](const tbb::blocked_range<int>& r) {
                      for (int i = r.begin(); i < r.end(); ++i) place(i);
                      problem.cost(stage, positions.col(r.begin()).data(), int(r.size()),
                                   costs.data() + r.begin());
                    });
}

/// State of a particle swarm, one column per particle. The caller moves the particles.
struct Swarm {
  /// \param global_best best position as long as no cost is finite
  Swarm(const Eigen::VectorXd& global_best, int particles)
      : position(global_best.size(), particles),
        velocity(Eigen::MatrixXd::Zero(global_best.size(), particles)),
        personal_best(global_best.size(), particles),
        cost(particles),
        personal_best_cost(Eigen::VectorXd::Constant(particles, HUGE_VAL)) {
    outcome.best = global_best;
    outcome.cost = HUGE_VAL;
  }

  /// Places and evaluates all particles; the first positions become the personal bests. The update
  /// of the bests is serial, so that ties do not depend on the number of threads.
  template <class PlaceT>
  void step(const SearchProblem& problem, int stage, int batch, const PlaceT& place) {
    evaluateInBatches(problem, stage, batch, place, position, cost);
    if (outcome.evaluations == 0) personal_best = position;
    outcome.evaluations += int(cost.size());
    for (Eigen::Index i = 0; i < cost.size(); ++i) {
      if (!std::isfinite(cost[i])) continue;
      outcome.found = true;
      if (cost[i] < personal_best_cost[i]) {
        personal_best_cost[i] = cost[i];
        personal_best.col(i) = position.col(i);
      }
      if (cost[i] < outcome.cost) {
        outcome.cost = cost[i];
        outcome.best = position.col(i);
      }
    }
  }

  const Eigen::VectorXd& globalBest() const { return outcome.best; }

  Eigen::MatrixXd position, velocity, personal_best;
  Eigen::VectorXd cost, personal_best_cost;
  SearchOutcome outcome;  ///< result so far; its best is the global best
};

}  // namespace markerless_mocap
