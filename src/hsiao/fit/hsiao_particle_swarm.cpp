#include "hsiao/fit/hsiao_particle_swarm.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "numerics/split_mix.h"

namespace markerless_mocap {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Particles judged by one call of the cost: enough work to be worth a task.
constexpr int kBatch = 16;

void check(const VectorXd& lower, const VectorXd& upper, const HsiaoSwarmSettings& settings) {
  if (lower.size() != upper.size() || !(lower.array() <= upper.array()).all())
    throw std::invalid_argument(
        "particle swarm: every lower bound must have an upper bound not below it");
  if (settings.particles < 1 || settings.iterations < 0)
    throw std::invalid_argument("particle swarm: " + std::to_string(settings.particles) +
                                " particles and " + std::to_string(settings.iterations) +
                                " iterations were asked for, at least 1 and 0 are needed");
}

// All positions are columns.
struct Swarm {
  MatrixXd position, velocity, personal_best;
  VectorXd cost, personal_best_cost, best;
  double best_cost = HUGE_VAL;
};

void judge(const HsiaoSwarmCost& cost, Swarm& swarm) {
  tbb::parallel_for(tbb::blocked_range<int>(0, int(swarm.position.cols()), kBatch),
                    [&](const tbb::blocked_range<int>& r) {
                      cost(swarm.position.col(r.begin()).data(), int(r.size()),
                           swarm.cost.data() + r.begin());
                    });
}

// Serial, so that ties fall the same way whatever the number of threads.
void remember(Swarm& swarm) {
  for (int i = 0; i < swarm.cost.size(); ++i) {
    if (swarm.cost[i] < swarm.personal_best_cost[i]) {
      swarm.personal_best_cost[i] = swarm.cost[i];
      swarm.personal_best.col(i) = swarm.position.col(i);
    }
    if (swarm.cost[i] < swarm.best_cost) {
      swarm.best_cost = swarm.cost[i];
      swarm.best = swarm.position.col(i);
    }
  }
}

Swarm scatter(const VectorXd& lower, const VectorXd& upper, const std::vector<VectorXd>& starts,
              const HsiaoSwarmSettings& settings) {
  const int dimensions = int(lower.size()), particles = settings.particles;
  Swarm swarm;
  swarm.position.resize(dimensions, particles);
  for (int i = 0; i < particles; ++i)
    for (int d = 0; d < dimensions; ++d) {
      const double share = uniformRandom(settings.seed, uint64_t(i) * dimensions + d);
      swarm.position(d, i) = size_t(i) < starts.size()
                                 ? std::min(std::max(starts[i][d], lower[d]), upper[d])
                                 : lower[d] + share * (upper[d] - lower[d]);
    }
  swarm.velocity = MatrixXd::Zero(dimensions, particles);
  swarm.personal_best = swarm.position;
  swarm.cost.resize(particles);
  swarm.personal_best_cost = VectorXd::Constant(particles, HUGE_VAL);
  swarm.best = swarm.position.col(0);
  return swarm;
}

void move(Swarm& swarm, const VectorXd& lower, const VectorXd& upper,
          const HsiaoSwarmSettings& settings, int iteration) {
  const int dimensions = int(lower.size()), particles = settings.particles;
  for (int i = 0; i < particles; ++i)
    for (int d = 0; d < dimensions; ++d) {
      const uint64_t counter = (uint64_t(iteration + 1) * particles + i) * (2 * dimensions) + 2 * d;
      double& p = swarm.position(d, i);
      double& v = swarm.velocity(d, i);
      v = settings.inertia * v +
          settings.cognitive_weight * uniformRandom(settings.seed, counter) *
              (swarm.personal_best(d, i) - p) +
          settings.social_weight * uniformRandom(settings.seed, counter + 1) * (swarm.best[d] - p);
      p += v;
      if (p >= lower[d] && p <= upper[d]) continue;
      p = std::min(std::max(p, lower[d]), upper[d]);
      v = 0.0;
    }
}

}  // namespace

double uniformRandom(uint64_t seed, uint64_t counter) {
  return splitMixUniform(seed * 0xD1342543DE82EF95ull + counter * 0x9E3779B97F4A7C15ull);
}

HsiaoSwarmResult minimiseByParticleSwarm(const HsiaoSwarmCost& cost, const VectorXd& lower,
                                         const VectorXd& upper, const std::vector<VectorXd>& starts,
                                         const HsiaoSwarmSettings& settings) {
  check(lower, upper, settings);
  Swarm swarm = scatter(lower, upper, starts, settings);
  judge(cost, swarm);
  remember(swarm);
  for (int iteration = 0; iteration < settings.iterations; ++iteration) {
    move(swarm, lower, upper, settings, iteration);
    judge(cost, swarm);
    remember(swarm);
  }
  return {swarm.best, swarm.best_cost};
}

}  // namespace markerless_mocap
