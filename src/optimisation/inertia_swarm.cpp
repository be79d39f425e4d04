#include "optimisation/inertia_swarm.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "numerics/split_mix.h"
#include "optimisation/detail/swarm.h"

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

// Number of particles that one task moves and evaluates.
constexpr int kBatch = 16;

double uniformRandom(uint64_t seed, uint64_t counter) {
  return splitMixUniform(seed * 0xD1342543DE82EF95ull + counter * 0x9E3779B97F4A7C15ull);
}

/// Particle i at its start, or anywhere inside the bounds.
void scatter(const SearchProblem& problem, const std::vector<VectorXd>& starts, uint64_t seed,
             int i, Swarm& swarm) {
  const auto dimensions = problem.lower.size();
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const double lower = problem.lower[d], upper = problem.upper[d];
    swarm.position(d, i) =
        size_t(i) < starts.size()
            ? std::clamp(starts[i][d], lower, upper)
            : lower + uniformRandom(seed, uint64_t(i * dimensions + d)) * (upper - lower);
  }
}

void move(const SearchProblem& problem, const InertiaSwarmSettings& settings, uint64_t seed,
          int iteration, int i, Swarm& swarm) {
  const auto dimensions = problem.lower.size();
  for (Eigen::Index d = 0; d < dimensions; ++d) {
    const uint64_t counter =
        2 * ((uint64_t(iteration) * settings.particles + i) * dimensions + uint64_t(d));
    double &p = swarm.position(d, i), &v = swarm.velocity(d, i);
    v = settings.inertia * v +
        settings.cognitive_weight * uniformRandom(seed, counter) * (swarm.personal_best(d, i) - p) +
        settings.social_weight * uniformRandom(seed, counter + 1) * (swarm.globalBest()[d] - p);
    p += v;
    if (p >= problem.lower[d] && p <= problem.upper[d]) continue;
    p = std::clamp(p, problem.lower[d], problem.upper[d]);
    v = 0.0;
  }
}

}  // namespace

InertiaSwarm::InertiaSwarm(const InertiaSwarmSettings& settings) : settings_(settings) {
  if (settings.particles < 1 || settings.iterations < 0)
    throw std::invalid_argument("particle swarm: " + std::to_string(settings.particles) +
                                " particles and " + std::to_string(settings.iterations) +
                                " iterations were asked for, at least 1 and 0 are needed");
}

SearchOutcome InertiaSwarm::minimise(const SearchProblem& problem,
                                     const std::vector<VectorXd>& starts, uint64_t seed) const {
  validateProblem(problem);
  const VectorXd fallback = starts.empty() ? problem.lower : starts.front();
  Swarm swarm(fallback.cwiseMax(problem.lower).cwiseMin(problem.upper), settings_.particles);
  swarm.step(problem, 0, kBatch, [&](int i) { scatter(problem, starts, seed, i, swarm); });
  for (int k = 1; k <= settings_.iterations; ++k)
    swarm.step(problem, 0, kBatch, [&](int i) { move(problem, settings_, seed, k, i, swarm); });
  return swarm.outcome;
}

}  // namespace markerless_mocap
