#pragma once

#include "numerics/counter_random.h"
#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// The particles of an annealed filter with their costs.
class ParticleSet {
 public:
  /// Scatters the particles around the start, or its particles, and evaluates them.
  ParticleSet(const SearchProblem& problem, const SearchStart& start, int particles,
              const CounterRandom& random);

  /// Moves each particle to its column of `centers` plus `root` times standard normal noise, which
  /// is drawn again until the particle is feasible, and evaluates all particles.
  void replace(const Eigen::MatrixXd& centers, const Eigen::MatrixXd& root,
               const CounterRandom& random);

  /// As many particles, drawn by weight with replacement.
  Eigen::MatrixXd drawn(const Eigen::VectorXd& weights, const CounterRandom& random) const;
  const Eigen::MatrixXd& positions() const { return positions_; }
  const Eigen::VectorXd& costs() const { return costs_; }
  /// The weighted mean, with the weighted mean of the costs.
  SearchOutcome outcome(const Eigen::VectorXd& weights) const;

 private:
  const SearchProblem& problem_;
  Eigen::VectorXd start_;
  Eigen::MatrixXd positions_;  // one column per particle
  Eigen::VectorXd costs_;
  int evaluations_ = 0, rejected_moves_ = 0;
};

/// Draws an index by weight.
/// \param u uniform random number in [0, 1)
int drawIndex(const Eigen::VectorXd& weights, double u);

/// Standard deviation of each row.
Eigen::VectorXd spreadOf(const Eigen::MatrixXd& positions);

}  // namespace markerless_mocap
