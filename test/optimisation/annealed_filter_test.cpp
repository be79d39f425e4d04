#include "optimisation/annealed_filter.h"

#include <gtest/gtest.h>

#include <tbb/global_control.h>

#include <memory>

#include "error_text_of.h"
#include "search_fixture.h"

namespace markerless_mocap {
namespace {

// Two costs, 1.6 of two to survive: w^2 + (1 - w)^2 = 1 / 1.6 gives w = 3/4, so exp(-beta) = 1/3.
TEST(AnnealedFilter, weightsLetTheWantedShareSurvive) {
  const Eigen::VectorXd weights = survivalWeights(Eigen::Vector2d(5.0, 6.0), 0.8);
  EXPECT_NEAR(weights[0], 0.75, 1e-9);
  EXPECT_NEAR(weights[1], 0.25, 1e-9);
  const Eigen::VectorXd same = survivalWeights(Eigen::Vector3d(2.0, 2.0, 2.0), 0.5);
  EXPECT_NEAR(same[1], 1.0 / 3, 1e-9);
  const Eigen::VectorXd some = survivalWeights(Eigen::Vector3d(NAN, 1.0, HUGE_VAL), 0.5);
  EXPECT_EQ(some, Eigen::Vector3d(0, 1, 0));
  const Eigen::VectorXd none = survivalWeights(Eigen::Vector2d(NAN, NAN), 0.5);
  EXPECT_EQ(none, Eigen::Vector2d(0.5, 0.5));
}

class AnnealedFilters : public testing::TestWithParam<bool> {
 protected:
  static std::unique_ptr<Optimiser> make(const AnnealingSettings& settings) {
    if (GetParam()) return std::make_unique<AnnealedParticleFilter>(settings);
    return std::make_unique<InteractingAnnealing>(settings);
  }
};

TEST_P(AnnealedFilters, comeNearTheBottomOfABowl) {
  AnnealingSettings settings;
  settings.inverse_temperature = 5.0;
  settings.layers = 10;
  const auto filter = make(settings);
  const SearchOutcome found = filter->minimise(unbounded(5, bowl(5)), around(5, 1.0, 0.7), 1);
  EXPECT_TRUE(found.found);
  EXPECT_EQ(found.evaluations, 2000);
  EXPECT_LT(bowl(5)(found.best.data()), 0.05);  // from 2.55
}

TEST_P(AnnealedFilters, findTheDeepestOfManyHollows) {
  AnnealingSettings settings;
  settings.inverse_temperature = 1.0;
  settings.layers = 12;
  const SearchOutcome found =
      make(settings)->minimise(unbounded(2, hollows), around(2, 1.7, 1.5), 3);
  EXPECT_LT(found.best.norm(), 0.15);
}

TEST_P(AnnealedFilters, askOnlyAboutWhatIsAllowedAndHoldWhatHasNoSigma) {
  SearchProblem problem = unbounded(3, bowl(3));
  problem.lower[0] = 0.5;
  problem.infeasible = [](const double* x) { return x[0] + x[1] > 3.0; };
  Witness witness;
  witness.attend(&problem);
  SearchStart start = around(3, 1.0, 1.0);
  start.sigma[2] = 0.0;
  make({})->minimise(problem, start, 1);
  EXPECT_EQ(witness.candidates.size(), 1000u);
  for (const Eigen::VectorXd& x : witness.candidates) {
    EXPECT_TRUE(isFeasible(problem, x.data()));
    EXPECT_EQ(x[2], 1.0);
  }
}

TEST_P(AnnealedFilters, constraintsThatNothingMeetsLeaveThemWhereTheyAre) {
  SearchProblem problem = unbounded(2, bowl(2));
  problem.infeasible = [](const double*) { return true; };
  const SearchOutcome found = make({})->minimise(problem, around(2, 1.0, 1.0), 1);
  EXPECT_EQ(found.rejected_moves, 1000);
  EXPECT_LT((found.best - Eigen::Vector2d(1, 1)).norm(), 1e-9);
}

TEST_P(AnnealedFilters, costsThatAreNoNumbersFindNothing) {
  const SearchOutcome none =
      make({})->minimise(unbounded(2, [](const double*) { return NAN; }), around(2, 1.0, 1.0), 1);
  EXPECT_FALSE(none.found);
  EXPECT_EQ(none.best, Eigen::VectorXd::Ones(2));
}

TEST_P(AnnealedFilters, dependOnTheSeedAndNotOnThreads) {
  AnnealingSettings settings;
  settings.crossover = 0.3;
  const auto filter = make(settings);
  const SearchProblem problem = unbounded(4, bowl(4));
  const SearchOutcome first = filter->minimise(problem, around(4, 2.0, 1.0), 7);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(filter->minimise(problem, around(4, 2.0, 1.0), 7).best, first.best);
  EXPECT_NE(filter->minimise(problem, around(4, 2.0, 1.0), 8).best, first.best);
}

// A filter over time goes on with all its particles, not with their mean.
TEST(AnnealedParticleFilter, startsWithTheParticlesOfTheLastSearch) {
  const AnnealedParticleFilter filter(AnnealingSettings{});
  const SearchProblem problem = unbounded(2, bowl(2));
  const SearchOutcome first = filter.minimise(problem, around(2, 1.0, 1.0), 1);
  ASSERT_EQ(first.particles.cols(), 200);
  EXPECT_LT((first.particles.rowwise().mean() - first.best).norm(), 0.2);
  SearchProblem next = problem;
  Witness witness;
  witness.attend(&next);
  SearchStart start = around(2, 50.0, 1e-6);
  start.particles = first.particles;
  filter.minimise(next, start, 2);
  const auto isOne = [&](const Eigen::VectorXd& x) {
    return (first.particles.colwise() - x).colwise().norm().minCoeff() < 1e-4;
  };
  const auto begin = witness.candidates.begin();
  EXPECT_TRUE(std::all_of(begin, begin + 200, isOne));
  start.particles.resize(3, 5);
  EXPECT_EQ(errorTextOf([&] { filter.minimise(problem, start, 2); }),
            "a search needs particles of as many values as the centre");
}

TEST_P(AnnealedFilters, sentencesSayWhatIsWrong) {
  AnnealingSettings settings;
  settings.particles = 1;
  EXPECT_EQ(errorTextOf([&] { make(settings); }),
            "an annealed filter needs at least two particles and one layer");
  settings = {};
  settings.survival_rate = 0.0;
  EXPECT_EQ(errorTextOf([&] { make(settings); }),
            "the survival of an annealed filter must be above 0, at most 1");
}

INSTANTIATE_TEST_SUITE_P(Both, AnnealedFilters, testing::Bool(), [](const auto& info) {
  return info.param ? "ParticleFilter" : "InteractingAnnealing";
});

}  // namespace
}  // namespace markerless_mocap
