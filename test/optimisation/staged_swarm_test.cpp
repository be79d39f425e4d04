#include "optimisation/staged_swarm.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>

#include "error_text_of.h"
#include "search_fixture.h"

namespace markerless_mocap {
namespace {

SwarmStage stageOf(int dimensions, int particles, int iterations, double sigma_scale = 1.0) {
  return {particles, iterations, Eigen::VectorXd::Constant(dimensions, sigma_scale)};
}

TEST(StagedSwarm, constrictionIsThatOfClercAndKennedy) {
  EXPECT_NEAR(constriction(4.1), 0.72984, 1e-5);
  // phi = 4.5: 2 / |2 - 4.5 - sqrt(20.25 - 18)| = 2 / 4
  EXPECT_DOUBLE_EQ(constriction(4.5), 0.5);
}

// A lone particle that always finds better things is its own and the swarm's best, so only inertia
// moves it: each step is chi(k) times the last one.
TEST(StagedSwarm, pullsRiseLinearlyOverTheIterations) {
  std::atomic<int> calls{0};
  SearchProblem problem = unbounded(1, [&](const double*) { return -double(++calls); });
  Witness witness;
  witness.attend(&problem);
  StagedSwarm({stageOf(1, 1, 5)}).minimise(problem, around(1, 0.3, 1.0), 4);
  ASSERT_EQ(witness.candidates.size(), 5u);
  for (int k = 2; k < 5; ++k) {
    const double step = (witness.candidates[k] - witness.candidates[k - 1])[0];
    const double last = (witness.candidates[k - 1] - witness.candidates[k - 2])[0];
    EXPECT_NEAR(step / last, constriction(2.0 * (2.05 + 0.1 * k / 4)), 1e-12) << k;
  }
}

TEST(StagedSwarm, findsTheBottomOfABowlInStages) {
  const int n = 31;
  SwarmStage first = stageOf(n, 10, 20, 0.0), second = stageOf(n, 20, 100);
  first.sigma_scale.head(6).setOnes();
  second.sigma_scale.head(3) *= 0.1;
  const StagedSwarm swarm({first, second});
  const SearchProblem problem = unbounded(n, bowl(n));
  const SearchStart start = around(n, 1.6, 1.0);
  const SearchOutcome found = swarm.minimise(problem, start, 1);
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.evaluations, 10 * 20 + 20 * 100);
  EXPECT_EQ(swarm.evaluations(), found.evaluations);
  EXPECT_LT(found.cost, 0.1 * bowl(n)(start.center.data()));
  EXPECT_DOUBLE_EQ(found.cost, bowl(n)(found.best.data()));
}

TEST(StagedSwarm, findsTheBottomOfACurvedValley) {
  const auto rosenbrock = [](const double* x) {
    return 100.0 * std::pow(x[1] - x[0] * x[0], 2) + std::pow(1.0 - x[0], 2);
  };
  const SearchOutcome found =
      StagedSwarm({stageOf(2, 40, 150)}).minimise(unbounded(2, rosenbrock), around(2, 0.0, 1.0), 2);
  EXPECT_NEAR(found.best[0], 1.0, 0.02);
  EXPECT_NEAR(found.best[1], 1.0, 0.04);
}

TEST(StagedSwarm, whatHasNoReachStaysAndStepsAreLimited) {
  SearchProblem problem = unbounded(3, bowl(3));
  Witness witness;
  witness.attend(&problem);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  SwarmStage stage = stageOf(3, 3, 30);  // as many as one task judges: they come in order
  stage.sigma_scale << 1.0, 0.0, 0.1;
  StagedSwarm({stage}).minimise(problem, around(3, 5.0, 0.5), 3);
  ASSERT_EQ(witness.candidates.size(), 90u);
  double farthest = 0.0;
  for (size_t i = 0; i < 90; ++i) {
    EXPECT_EQ(witness.candidates[i][1], 5.0);
    if (i < 3) continue;
    const Eigen::VectorXd step = witness.candidates[i] - witness.candidates[i - 3];
    EXPECT_LE(std::abs(step[0]), 1.0 + 1e-12);
    EXPECT_LE(std::abs(step[2]), 0.1 + 1e-12);
    farthest = std::max(farthest, std::abs(step[0]));
  }
  EXPECT_GT(farthest, 0.9);
}

TEST(StagedSwarm, asksOnlyAboutWhatIsAllowed) {
  SearchProblem problem = unbounded(2, bowl(2));
  problem.lower << 0.5, -HUGE_VAL;
  problem.infeasible = [](const double* x) { return x[0] + x[1] > 3.0; };
  Witness witness;
  witness.attend(&problem);
  const SearchOutcome found =
      StagedSwarm({stageOf(2, 10, 60)}).minimise(problem, around(2, 1.4, 1.0), 1);
  for (const Eigen::VectorXd& x : witness.candidates) EXPECT_TRUE(isFeasible(problem, x.data()));
  EXPECT_NEAR(found.best[0], 0.5, 0.01);
  EXPECT_NEAR(found.best[1], 0.2, 0.01);
}

TEST(StagedSwarm, constraintsThatNothingMeetsCostABoundedNumberOfDraws) {
  SearchProblem problem = unbounded(2, bowl(2));
  std::atomic<int> draws{0};
  problem.infeasible = [&](const double*) {
    ++draws;
    return true;
  };
  const SearchOutcome found =
      StagedSwarm({stageOf(2, 4, 5)}).minimise(problem, around(2, 1.0, 1.0), 1);
  EXPECT_EQ(found.rejected_moves, 20);
  EXPECT_EQ(draws, 20 * (SearchProblem().attempts + 1));
  EXPECT_EQ(found.best, Eigen::VectorXd::Ones(2));
}

TEST(StagedSwarm, costsThatAreNoNumbersAreInfinitelyBad) {
  const SearchOutcome none =
      StagedSwarm({stageOf(2, 4, 5)})
          .minimise(unbounded(2, [](const double*) { return NAN; }), around(2, 1.0, 1.0), 1);
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.best, Eigen::VectorXd::Ones(2));
  const SearchProblem half =
      unbounded(2, [](const double* x) { return x[0] < 0.2 ? NAN : bowl(2)(x); });
  const SearchOutcome found =
      StagedSwarm({stageOf(2, 10, 40)}).minimise(half, around(2, 1.0, 1.0), 1);
  EXPECT_TRUE(found.found);
  EXPECT_GE(found.best[0], 0.2);
  EXPECT_LT(found.cost, 0.02);
}

TEST(StagedSwarm, aCentreThatIsKeptIsNeverLost) {
  const SearchStart best = {Eigen::Vector3d(0.1, 0.2, 0.3), Eigen::Vector3d::Ones()};
  const SearchProblem problem = unbounded(3, bowl(3));
  StagedSwarmSettings keeping;
  keeping.keep_center = true;
  EXPECT_EQ(StagedSwarm({stageOf(3, 4, 2)}, keeping).minimise(problem, best, 5).best, best.center);
  EXPECT_NE(StagedSwarm({stageOf(3, 4, 2)}).minimise(problem, best, 5).best, best.center);
}

TEST(StagedSwarm, dependsOnTheSeedAndNotOnThreads) {
  const SearchProblem problem = unbounded(6, bowl(6));
  const StagedSwarm swarm({stageOf(6, 20, 20)});
  const SearchOutcome first = swarm.minimise(problem, around(6, 2.0, 1.0), 7);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(swarm.minimise(problem, around(6, 2.0, 1.0), 7).best, first.best);
  EXPECT_NE(swarm.minimise(problem, around(6, 2.0, 1.0), 8).best, first.best);
}

TEST(StagedSwarm, stagesAreToldToTheCost) {
  std::atomic<int> calls[2] = {{0}, {0}};
  SearchProblem problem = unbounded(1, bowl(1));
  problem.cost = [&](int stage, const double*, int count, double* costs) {
    calls[stage] += count;
    for (int i = 0; i < count; ++i) costs[i] = 1.0;
  };
  StagedSwarm({stageOf(1, 3, 4), stageOf(1, 5, 6)}).minimise(problem, around(1, 0.0, 1.0), 1);
  EXPECT_EQ(calls[0], 12);
  EXPECT_EQ(calls[1], 30);
}

TEST(StagedSwarm, isWatchedInEveryIterationAndKeepsToItsVelocity) {
  StagedSwarmSettings settings;
  settings.max_velocity = 0.5;
  std::vector<Eigen::MatrixXd> seen[2];
  settings.watch = [&](int stage, const Eigen::MatrixXd& positions) {
    seen[stage].push_back(positions);
  };
  StagedSwarm({stageOf(2, 3, 4), stageOf(2, 5, 6)}, settings)
      .minimise(unbounded(2, bowl(2)), around(2, 3.0, 1.0), 1);
  ASSERT_EQ(seen[0].size(), 4u);
  ASSERT_EQ(seen[1].size(), 6u);
  for (size_t k = 1; k < seen[1].size(); ++k) {
    const double most = (seen[1][k] - seen[1][k - 1]).cwiseAbs().maxCoeff();
    EXPECT_GT(most, 0.0);
    EXPECT_LE(most, 0.5 + 1e-12);
  }
}

TEST(StagedSwarm, sentencesSayWhatIsWrong) {
  StagedSwarmSettings slow;
  slow.final_acceleration = 2.0;
  EXPECT_EQ(errorTextOf([&] { StagedSwarm({stageOf(2, 3, 4)}, slow); }),
            "the accelerations of a staged swarm must be above 2");
  EXPECT_EQ(errorTextOf([] { StagedSwarm({}); }), "a staged swarm needs at least one stage");
  EXPECT_EQ(errorTextOf([] { StagedSwarm({stageOf(2, 0, 5)}); }),
            "swarm stage 0 needs at least one particle and one iteration");
  EXPECT_EQ(errorTextOf([] {
              StagedSwarm({stageOf(2, 5, 5), stageOf(2, 5, 5, -1.0)});
            }),
            "swarm stage 1 needs a reach of at least 0 for each parameter");
  const StagedSwarm swarm({stageOf(2, 5, 5)});
  EXPECT_EQ(errorTextOf([&] { swarm.minimise(unbounded(3, bowl(3)), around(3, 0, 1), 1); }),
            "a staged swarm for 2 parameters cannot search 3");
  SearchProblem problem = unbounded(2, bowl(2));
  problem.lower[1] = 2.0;
  problem.upper[1] = 1.0;
  EXPECT_EQ(errorTextOf([&] { swarm.minimise(problem, around(2, 0, 1), 1); }),
            "parameter 1 of a search has a lower bound above its upper one");
  EXPECT_EQ(errorTextOf([&] { swarm.minimise(unbounded(2, bowl(2)), around(2, NAN, 1), 1); }),
            "parameter 0 of a search starts at a value that is not finite");
  EXPECT_EQ(errorTextOf([&] { swarm.minimise(unbounded(2, bowl(2)), around(2, 0, -1), 1); }),
            "parameter 0 of a search needs a finite sigma of at least 0");
}

}  // namespace
}  // namespace markerless_mocap
