#include "optimisation/inertia_swarm.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "numerics/split_mix.h"
#include "optimisation/detail/swarm.h"

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

// Particles that one task moves and judges.
constexpr int kBatch = 16;

double uniformRandom(uint64_t seed, uint64_t counter) {
  return splitMixUniform(seed * 0xD1342543DE82EF95ull + counter * 0x9E3779B97F4A7C15ull);
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
  const VectorXd &lower = problem.lower, &upper = problem.upper;
  const auto dimensions = lower.size();
  const VectorXd fallback =
      starts.empty() ? lower : VectorXd(starts.front().cwiseMax(lower).cwiseMin(upper));
  Swarm swarm(fallback, settings_.particles);
  swarm.step(problem, 0, kBatch, [&](int i) {
    for (Eigen::Index d = 0; d < dimensions; ++d) {
      const double share = uniformRandom(seed, uint64_t(i) * dimensions + d);
      swarm.position(d, i) = size_t(i) < starts.size()
                                 ? std::clamp(starts[i][d], lower[d], upper[d])
                                 : lower[d] + share * (upper[d] - lower[d]);
    }
  });
  for (int k = 1; k <= settings_.iterations; ++k)
    swarm.step(problem, 0, kBatch, [&](int i) {
      const uint64_t counter =
          (uint64_t(k) * settings_.particles + uint64_t(i)) * uint64_t(2 * dimensions);
      for (Eigen::Index d = 0; d < dimensions; ++d) {
        double &p = swarm.position(d, i), &v = swarm.velocity(d, i);
        v = settings_.inertia * v +
            settings_.cognitive_weight * uniformRandom(seed, counter + 2 * d) *
                (swarm.personal_best(d, i) - p) +
            settings_.social_weight * uniformRandom(seed, counter + 2 * d + 1) *
                (swarm.globalBest()[d] - p);
        p += v;
        if (p >= lower[d] && p <= upper[d]) continue;
        p = std::clamp(p, lower[d], upper[d]);
        v = 0.0;
      }
    });
  return swarm.outcome;
}

}  // namespace markerless_mocap
