#include "optimisation/inertia_swarm.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <set>

#include "error_text_of.h"
#include "numerics/counter_random.h"
#include "search_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::VectorXd;

double rosenbrock(const double* x) {
  return 100 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1 - x[0], 2);
}

SearchProblem within(int dimensions, double reach, std::function<double(const double*)> cost) {
  SearchProblem problem = unbounded(dimensions, std::move(cost));
  problem.lower.setConstant(-reach);
  problem.upper.setConstant(reach);
  return problem;
}

SearchOutcome search(const SearchProblem& problem, int particles, int iterations,
                     const std::vector<VectorXd>& starts = {}, uint64_t seed = 1) {
  InertiaSwarmSettings settings;
  settings.particles = particles;
  settings.iterations = iterations;
  return InertiaSwarm(settings).minimise(problem, starts, seed);
}

TEST(InertiaSwarm, FindsTheBottomOfABowl) {
  const SearchOutcome found = search(within(4, 3.0, bowl(4)), 40, 120);
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.evaluations, 40 * 121);
  EXPECT_LT((found.best - Eigen::Vector4d(0.1, 0.2, 0.3, 0.4)).norm(), 1e-4);
  EXPECT_DOUBLE_EQ(found.cost, bowl(4)(found.best.data()));
}

TEST(InertiaSwarm, FindsTheEndOfRosenbrocksValley) {
  const SearchOutcome found = search(within(2, 2.0, rosenbrock), 60, 300);
  EXPECT_NEAR(found.best[0], 1.0, 1e-3);
  EXPECT_NEAR(found.best[1], 1.0, 2e-3);
}

// Particles begin at rest: the best one is pulled by nothing and stays, the other is first pulled
// by the global best alone, at most by the social weight times its distance.
TEST(InertiaSwarm, TheBestParticleStaysAndPullsTheOther) {
  SearchProblem problem = within(1, 3.0, [](const double* x) { return std::abs(x[0] - 0.3); });
  Witness witness;
  witness.attend(&problem);
  search(problem, 2, 1, {VectorXd::Constant(1, 0.3), VectorXd::Constant(1, 1.3)});
  ASSERT_EQ(witness.candidates.size(), 4u);
  EXPECT_EQ(witness.candidates[2][0], 0.3);
  EXPECT_LT(witness.candidates[3][0], 1.3);
  EXPECT_GE(witness.candidates[3][0], 1.3 - InertiaSwarmSettings().social_weight * 1.0);
}

TEST(InertiaSwarm, NeverLeavesTheBoundsAndEndsOnTheNearestOne) {
  SearchProblem problem = unbounded(2, bowl(2));  // its bottom, 0.1 and 0.2, is outside
  problem.lower << -3.0, 0.0;
  problem.upper << -1.0, 1.0;
  Witness witness;
  witness.attend(&problem);
  const SearchOutcome found = search(problem, 30, 60, {Eigen::Vector2d(100.0, -100.0)});
  EXPECT_EQ(witness.candidates.size(), 30u * 61u);
  for (const VectorXd& x : witness.candidates) EXPECT_TRUE(isFeasible(problem, x.data()));
  EXPECT_EQ(found.best[0], -1.0);
  EXPECT_NEAR(found.best[1], 0.2, 1e-4);
}

TEST(InertiaSwarm, DependsOnTheSeedAndNotOnThreads) {
  const SearchProblem problem = within(2, 2.0, rosenbrock);
  const VectorXd first = search(problem, 100, 15).best;
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(search(problem, 100, 15).best, first);
  EXPECT_NE(search(problem, 100, 15, {}, 2).best, first);
}

TEST(InertiaSwarm, KeepsAStartThatNothingBeats) {
  const Eigen::Vector3d bottom(0.1, 0.2, 0.3);
  EXPECT_EQ(search(within(3, 1.0, bowl(3)), 5, 5, {bottom}).best, bottom);
}

TEST(InertiaSwarm, CostsThatAreNoNumbersFindNothing) {
  const SearchOutcome none =
      search(within(2, 1.0, [](const double*) { return NAN; }), 5, 5, {Eigen::Vector2d(0.5, 3.0)});
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.best, Eigen::Vector2d(0.5, 1.0));
}

TEST(InertiaSwarm, RefusesCrossedBoundsAndAnEmptySwarm) {
  EXPECT_EQ(errorTextOf([] { search(within(2, -1.0, rosenbrock), 5, 5); }),
            "parameter 0 of a search has a lower bound above its upper one");
  SearchProblem uneven = within(2, 1.0, rosenbrock);
  uneven.upper.resize(1);
  EXPECT_EQ(errorTextOf([&] { search(uneven, 5, 5); }),
            "a search needs as many lower bounds as upper ones, at least one");
  EXPECT_EQ(errorTextOf([] { search(within(2, 1.0, rosenbrock), 0, 5); }),
            "particle swarm: 0 particles and 5 iterations were asked for, at least 1 and 0 are "
            "needed");
}

TEST(CounterRandom, IsUniformAndWithoutRepeats) {
  std::set<double> values;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double r = CounterRandom(7).uniform(uint64_t(i));
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
