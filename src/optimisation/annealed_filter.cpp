#include "optimisation/annealed_filter.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "optimisation/detail/particle_set.h"

namespace markerless_mocap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Gall et al. 2007, 5.2: exponent of the schedule, factor of the covariance, regularisation.
constexpr double kScheduleExponent = 0.7, kCovarianceShare = 0.4, kLeastVariance = 1e-12;

void require(const AnnealingSettings& s) {
  if (s.particles < 2 || s.layers < 1)
    throw std::invalid_argument("an annealed filter needs at least two particles and one layer");
  if (!(s.survival_rate > 0.0 && s.survival_rate <= 1.0))
    throw std::invalid_argument("the survival of an annealed filter must be above 0, at most 1");
  if (!(s.crossover >= 0.0 && s.crossover <= 1.0))
    throw std::invalid_argument("the crossover of an annealed filter must be 0 to 1");
  if (!(s.inverse_temperature > 0.0))
    throw std::invalid_argument("the sharpness of an annealed filter must be above 0");
}

VectorXd weightsAt(const VectorXd& costs, double least, double beta) {
  VectorXd weights(costs.size());
  for (Eigen::Index i = 0; i < costs.size(); ++i)
    weights[i] = std::isfinite(costs[i]) ? std::exp(-beta * (costs[i] - least)) : 0.0;
  return weights / weights.sum();
}

double minOf(const VectorXd& costs) {
  double least = HUGE_VAL;
  for (const double cost : costs)
    if (std::isfinite(cost)) least = std::min(least, cost);
  return least;
}

/// A range of parameters is taken from a second survivor.
void crossOver(const ParticleSet& set, const VectorXd& weights, const CounterRandom& random,
               double probability, MatrixXd& next) {
  const auto dimensions = next.rows();
  for (Eigen::Index i = 0; i < next.cols(); ++i) {
    const CounterRandom own = random.stream(uint64_t(i));
    if (own.uniform(0) >= probability) continue;
    const int other = drawIndex(weights, own.uniform(1));
    const auto first = Eigen::Index(own.uniform(2) * double(dimensions));
    const auto count = Eigen::Index(own.uniform(3) * double(dimensions - first)) + 1;
    next.block(first, i, count, 1) = set.positions().block(first, other, count, 1);
  }
}

}  // namespace

VectorXd survivalWeights(const VectorXd& costs, double fraction) {
  const double least = minOf(costs);
  const auto finite =
      std::count_if(costs.begin(), costs.end(), [](double cost) { return std::isfinite(cost); });
  if (finite == 0) return VectorXd::Constant(costs.size(), 1.0 / double(costs.size()));
  const auto survivors = [&](double beta) {
    return 1.0 / weightsAt(costs, least, beta).squaredNorm();
  };
  const double wanted = std::max(1.0, fraction * double(finite));
  double low = 0.0, high = 1.0;
  constexpr double kSharpest = 1e12;
  while (survivors(high) > wanted && high < kSharpest) high *= 4.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (survivors(middle) > wanted ? low : high) = middle;
  }
  return weightsAt(costs, least, high);
}

AnnealedParticleFilter::AnnealedParticleFilter(const AnnealingSettings& settings)
    : settings_(settings) {
  require(settings);
}

SearchOutcome AnnealedParticleFilter::minimise(const SearchProblem& problem,
                                               const SearchStart& start, uint64_t seed) const {
  validateProblem(problem, start);
  const CounterRandom random(seed);
  ParticleSet set(problem, start, settings_.particles, random.stream(0));
  VectorXd sigma = start.sigma;
  VectorXd weights = survivalWeights(set.costs(), settings_.survival_rate);
  for (int layer = 1; layer < settings_.layers; ++layer) {
    const CounterRandom own = random.stream(uint64_t(layer));
    MatrixXd next = set.drawn(weights, own.stream(0));
    sigma = sigma.cwiseMin(spreadOf(next));
    crossOver(set, weights, own.stream(1), settings_.crossover, next);
    set.replace(next, sigma.asDiagonal(), own.stream(2));
    weights = survivalWeights(set.costs(), settings_.survival_rate);
  }
  SearchOutcome outcome = set.outcome(weights);
  outcome.particles = set.drawn(weights, random.stream(uint64_t(settings_.layers)));
  return outcome;
}

InteractingAnnealing::InteractingAnnealing(const AnnealingSettings& settings)
    : settings_(settings) {
  require(settings);
}

SearchOutcome InteractingAnnealing::minimise(const SearchProblem& problem, const SearchStart& start,
                                             uint64_t seed) const {
  validateProblem(problem, start);
  const CounterRandom random(seed);
  ParticleSet set(problem, start, settings_.particles, random.stream(0));
  const auto weightsOf = [&](int layer) -> VectorXd {
    const double least = minOf(set.costs());
    if (!std::isfinite(least)) return survivalWeights(set.costs(), 1.0);
    return weightsAt(set.costs(), least,
                     settings_.inverse_temperature * std::pow(layer + 1.0, kScheduleExponent));
  };
  VectorXd weights = weightsOf(0);
  for (int layer = 1; layer < settings_.layers; ++layer) {
    const CounterRandom own = random.stream(uint64_t(layer));
    MatrixXd next = set.positions();
    for (int i = 0; i < settings_.particles; ++i)
      if (own.stream(0).uniform(uint64_t(i)) * weights.maxCoeff() >= weights[i])
        next.col(i) = set.positions().col(drawIndex(weights, own.stream(1).uniform(uint64_t(i))));
    const MatrixXd centered = next.colwise() - next.rowwise().mean();
    MatrixXd covariance = centered * centered.transpose();
    covariance.diagonal().array() += kLeastVariance;
    covariance *= kCovarianceShare / (settings_.particles - 1);
    // Fixed parameters have only the regularisation as variance; they must not move at all.
    const VectorXd moving = (start.sigma.array() > 0.0).cast<double>();
    const MatrixXd root = covariance.llt().matrixL();
    set.replace(next, moving.asDiagonal() * root, own.stream(2));
    weights = weightsOf(layer);
  }
  return set.outcome(weights);
}

}  // namespace markerless_mocap
