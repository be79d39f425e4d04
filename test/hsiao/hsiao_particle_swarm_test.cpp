#include "hsiao/fit/hsiao_particle_swarm.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cmath>
#include <set>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

HsiaoSwarmCost shiftedSphere(const VectorXd& center) {
  return [center](const double* candidates, int count, double* costs) {
    for (int i = 0; i < count; ++i)
      costs[i] =
          (Eigen::Map<const VectorXd>(candidates + i * center.size(), center.size()) - center)
              .squaredNorm();
  };
}

void rosenbrock(const double* candidates, int count, double* costs) {
  for (int i = 0; i < count; ++i) {
    const double x = candidates[2 * i], y = candidates[2 * i + 1];
    costs[i] = 100 * std::pow(y - x * x, 2) + std::pow(1 - x, 2);
  }
}

HsiaoSwarmSettings settings(int particles, int iterations) {
  HsiaoSwarmSettings s;
  s.particles = particles;
  s.iterations = iterations;
  return s;
}

TEST(ParticleSwarm, FindsTheCenterOfAShiftedSphere) {
  VectorXd center(4);
  center << 0.3, -1.2, 2.0, 0.0;
  const HsiaoSwarmResult found =
      minimiseByParticleSwarm(shiftedSphere(center), VectorXd::Constant(4, -3),
                              VectorXd::Constant(4, 3), {}, settings(40, 120));
  EXPECT_LT((found.best - center).norm(), 1e-4);
  EXPECT_NEAR(found.cost, (found.best - center).squaredNorm(), 1e-15);
}

TEST(ParticleSwarm, FindsTheEndOfRosenbrocksValley) {
  const HsiaoSwarmResult found = minimiseByParticleSwarm(
      rosenbrock, VectorXd::Constant(2, -2), VectorXd::Constant(2, 2), {}, settings(60, 300));
  EXPECT_NEAR(found.best[0], 1.0, 1e-3);
  EXPECT_NEAR(found.best[1], 1.0, 2e-3);
}

TEST(ParticleSwarm, NeverLeavesTheBoundsAndEndsOnTheNearestOne) {
  VectorXd center(2), lower(2), upper(2);
  center << 5.0, 0.5;  // outside in x
  lower << -1.0, 0.0;
  upper << 1.0, 1.0;
  std::atomic<bool> left{false};
  const HsiaoSwarmCost sphere = shiftedSphere(center);
  const auto watched = [&](const double* candidates, int count, double* costs) {
    for (int i = 0; i < 2 * count; ++i)
      if (candidates[i] < lower[i % 2] || candidates[i] > upper[i % 2]) left = true;
    sphere(candidates, count, costs);
  };
  VectorXd far(2);
  far << 100.0, -100.0;
  const HsiaoSwarmResult found =
      minimiseByParticleSwarm(watched, lower, upper, {far}, settings(30, 60));
  EXPECT_FALSE(left);
  EXPECT_EQ(found.best[0], 1.0);
  EXPECT_NEAR(found.best[1], 0.5, 1e-4);
}

TEST(ParticleSwarm, GivesTheSameResultForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return minimiseByParticleSwarm(rosenbrock, VectorXd::Constant(2, -2), VectorXd::Constant(2, 2),
                                   {}, settings(100, 15))
        .best;
  };
  const VectorXd one = run(1), two = run(2);
  EXPECT_EQ(one[0], two[0]);
  EXPECT_EQ(one[1], two[1]);
}

TEST(ParticleSwarm, ANewSeedSearchesElsewhere) {
  HsiaoSwarmSettings other = settings(10, 3);
  other.seed = 2;
  const auto search = [](const HsiaoSwarmSettings& s) {
    return minimiseByParticleSwarm(rosenbrock, VectorXd::Constant(2, -2), VectorXd::Constant(2, 2),
                                   {}, s)
        .best;
  };
  EXPECT_NE(search(settings(10, 3))[0], search(other)[0]);
}

TEST(ParticleSwarm, KeepsAStartThatNothingBeats) {
  VectorXd center(3);
  center << 0.1, 0.2, 0.3;
  const HsiaoSwarmResult found =
      minimiseByParticleSwarm(shiftedSphere(center), VectorXd::Constant(3, -1),
                              VectorXd::Constant(3, 1), {center}, settings(5, 5));
  EXPECT_EQ(found.cost, 0.0);
}

TEST(ParticleSwarm, RefusesCrossedBoundsAndAnEmptySwarm) {
  const VectorXd zero = VectorXd::Zero(2), one = VectorXd::Ones(2);
  EXPECT_THROW(minimiseByParticleSwarm(rosenbrock, one, zero, {}, settings(5, 5)),
               std::invalid_argument);
  EXPECT_THROW(minimiseByParticleSwarm(rosenbrock, zero, one, {}, settings(0, 5)),
               std::invalid_argument);
}

TEST(CounterRandom, IsUniformAndWithoutRepeats) {
  std::set<double> values;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double r = uniformRandom(7, i);
    ASSERT_GE(r, 0.0);
    ASSERT_LT(r, 1.0);
    values.insert(r);
    sum += r;
    squares += r * r;
  }
  EXPECT_EQ(values.size(), 10000u);
  EXPECT_NEAR(sum / 10000, 0.5, 0.015);
  EXPECT_NEAR(squares / 10000, 1.0 / 3.0, 0.015);
}

}  // namespace
}  // namespace markerless_mocap
