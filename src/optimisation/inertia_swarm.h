#pragma once

#include <vector>

#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// Settings of an inertia weight particle swarm; t1, t2 and t3 of Hsiao 2008.
struct InertiaSwarmSettings {
  int particles = 40;
  int iterations = 40;            ///< moves of each particle
  double inertia = 0.6;           ///< t1
  double cognitive_weight = 1.5;  ///< t2, towards the particle's personal best
  double social_weight = 1.5;     ///< t3, towards the global best
};

/// Particle swarm with an inertia weight (Shi and Eberhart 1998) as in Hsiao 2008, 3.2.2.2: v <- t1
/// v + t2 rand (b - p) + t3 rand (gb - p), p <- p + v, clamped to the bounds.
class InertiaSwarm {
 public:
  /// Throws std::invalid_argument without particles or with negative iterations.
  explicit InertiaSwarm(const InertiaSwarmSettings& settings);
  /// The result depends on the arguments only, not on the number of threads.
  /// \param problem its bounds must be finite if particles start at random; only the bounds are
  ///   enforced, `infeasible` is not used
  /// \param starts start positions of the first particles, clamped to the bounds; the others start
  ///   at random inside the bounds
  /// Throws std::invalid_argument if the bounds differ in size or cross.
  SearchOutcome minimise(const SearchProblem& problem, const std::vector<Eigen::VectorXd>& starts,
                         uint64_t seed) const;

 private:
  InertiaSwarmSettings settings_;
};

}  // namespace markerless_mocap
