#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

namespace markerless_mocap {

/// Costs of `count` candidates that stand one behind the other, each `dimensions` values. Called
/// from several threads at once. NaN counts as infinitely bad.
using HsiaoSwarmCost = std::function<void(const double* candidates, int count, double* costs)>;

/// Settings of one particle swarm search.
struct HsiaoSwarmSettings {
  int particles = 40;
  int iterations = 40;
  double inertia = 0.6;           ///< t1
  double cognitive_weight = 1.5;  ///< t2, towards the particle's own best
  double social_weight = 1.5;     ///< t3, towards the swarm's best
  uint64_t seed = 1;
};

/// Outcome of a search.
struct HsiaoSwarmResult {
  Eigen::VectorXd best;
  double cost = 0.0;
};

/// Uniform number in [0, 1) that depends on nothing but its arguments.
double uniformRandom(uint64_t seed, uint64_t counter);

/// Particle swarm of Hsiao 2008, 3.2.2.2: v <- t1 v + t2 rand (b - p) + t3 rand (gb - p),
/// p <- p + v, stopped at the bounds. The result depends on the seed, not on the thread count.
/// \param starts first positions of the first particles (moved inside the bounds); the others
///   start anywhere inside
/// Throws std::invalid_argument if the bounds differ in size or cross, or if there is no particle.
HsiaoSwarmResult minimiseByParticleSwarm(const HsiaoSwarmCost& cost, const Eigen::VectorXd& lower,
                                         const Eigen::VectorXd& upper,
                                         const std::vector<Eigen::VectorXd>& starts,
                                         const HsiaoSwarmSettings& settings);

}  // namespace markerless_mocap
