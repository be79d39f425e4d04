#pragma once

#include "numerics/counter_random.h"
#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// The particles of an annealed filter with their costs.
class ParticleSet {
 public:
  /// Scatters them about the start and judges them.
  ParticleSet(const SearchProblem& problem, const SearchStart& start, int particles,
              const CounterRandom& random);

  /// Moves each particle to `centers`' column plus `root` times standard normal noise, drawn anew
  /// until it is allowed, and judges all.
  void replace(const Eigen::MatrixXd& centers, const Eigen::MatrixXd& root,
               const CounterRandom& random);

  const Eigen::MatrixXd& positions() const { return positions_; }
  const Eigen::VectorXd& costs() const { return costs_; }
  /// The weighted mean, with the weighted mean of the costs.
  SearchOutcome outcome(const Eigen::VectorXd& weights) const;

 private:
  const SearchProblem& problem_;
  Eigen::VectorXd start_;
  Eigen::MatrixXd positions_;  // a particle is a column
  Eigen::VectorXd costs_;
  int evaluations_ = 0, rejected_moves_ = 0;
};

/// Index by weight. \param share in [0, 1)
int drawIndex(const Eigen::VectorXd& weights, double fraction);

/// Standard deviation of each row.
Eigen::VectorXd spreadOf(const Eigen::MatrixXd& positions);

}  // namespace markerless_mocap
