#pragma once

#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// Settings of the annealed filters.
struct AnnealingSettings {
  int particles = 200;
  int layers = 5;
  /// Annealed particle filter: fraction of the particles that survive a layer.
  double survival_rate = 0.5;
  /// Annealed particle filter: probability that a particle takes a range of its parameters from a
  /// second survivor.
  double crossover = 0.0;
  /// Interacting simulated annealing: weights of layer k, from 0, are exp(-inverse_temperature (k +
  /// 1)^0.7 cost).
  double inverse_temperature = 100.0;
};

/// Annealed particle filter after Deutscher and Reid 2005. Each layer resamples all particles with
/// weights that give the survival rate, and scatters them with the survivors' standard deviation of
/// each parameter, limited to that of the last layer. Parameters that affect the cost most converge
/// first. The result is the weighted mean of the last layer. Its particles can be handed to the
/// next search, as a filter over time does.
class AnnealedParticleFilter : public Optimiser {
 public:
  /// Throws std::invalid_argument on settings out of range.
  explicit AnnealedParticleFilter(const AnnealingSettings& settings);
  SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                         uint64_t seed) const override;

 private:
  AnnealingSettings settings_;
};

/// Interacting simulated annealing after Gall et al. 2007. A particle is kept with a probability
/// equal to its weight divided by the maximum weight; otherwise it is replaced by a particle drawn
/// by weight. Then all particles are scattered with 0.4 times their covariance. The result is the
/// weighted mean of the last layer.
class InteractingAnnealing : public Optimiser {
 public:
  /// Throws std::invalid_argument on settings out of range.
  explicit InteractingAnnealing(const AnnealingSettings& settings);
  SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                         uint64_t seed) const override;

 private:
  AnnealingSettings settings_;
};

/// Weights exp(-beta (cost - minimum cost)), normalised to a sum of 1. Beta is chosen so that 1 /
/// sum w^2 is `fraction` times the number of finite costs. Costs that are not finite get weight 0.
/// Weights are equal if costs are equal.
/// \param fraction in (0, 1]
Eigen::VectorXd survivalWeights(const Eigen::VectorXd& costs, double fraction);

}  // namespace markerless_mocap
