#pragma once

#include "optimisation/optimiser.h"

namespace markerless_mocap {

/// Settings of the annealed filters.
struct AnnealingSettings {
  int particles = 200;
  int layers = 5;
  /// Annealed particle filter: share of the particles that is to survive a layer.
  double survival_rate = 0.5;
  /// Annealed particle filter: probability that a particle takes a run of its parameters from a
  /// second survivor.
  double crossover = 0.0;
  /// Interacting simulated annealing: weights of layer k, from 0, are
  /// exp(-sharpness (k + 1)^0.7 cost).
  double inverse_temperature = 100.0;
};

/// Annealed particle filter after Deutscher and Reid 2005: each layer resamples all particles by
/// weights that let `survival` of them live, and scatters them anew with the spread that the
/// survivors have in each parameter, at most the last layer's: parameters that matter settle
/// first. The result is the weighted mean of the last layer.
class AnnealedParticleFilter : public Optimiser {
 public:
  /// Throws std::invalid_argument on settings out of range.
  explicit AnnealedParticleFilter(const AnnealingSettings& settings);
  SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                         uint64_t seed) const override;

 private:
  AnnealingSettings settings_;
};

/// Interacting simulated annealing after Gall et al. 2007: a particle is kept with a probability
/// that is its weight against the highest, otherwise replaced by one drawn by weight; then all are
/// scattered with 0.4 times the covariance of the particles. The result is the weighted mean of the
/// last layer.
class InteractingAnnealing : public Optimiser {
 public:
  /// Throws std::invalid_argument on settings out of range.
  explicit InteractingAnnealing(const AnnealingSettings& settings);
  SearchOutcome minimise(const SearchProblem& problem, const SearchStart& start,
                         uint64_t seed) const override;

 private:
  AnnealingSettings settings_;
};

/// Weights exp(-beta (cost - least cost)), their sum 1, with beta such that 1 / sum w^2 is `share`
/// of the number of finite costs; costs that are not finite weigh 0. Equal when costs are equal.
/// \param share in (0, 1]
Eigen::VectorXd survivalWeights(const Eigen::VectorXd& costs, double fraction);

}  // namespace markerless_mocap
