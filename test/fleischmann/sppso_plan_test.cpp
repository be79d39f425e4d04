#include "fleischmann/search/sppso_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "optimisation/staged_swarm.h"
#include "sentence_of.h"

namespace markerless_mocap {
namespace {

const std::vector<SwarmStage>& stagesOf(const SppsoPlan& plan) {
  return dynamic_cast<const StagedSwarm&>(*plan.optimiser).stages();
}

SppsoPlan planFor(const std::string& search) {
  SppsoOptions options;
  options.search = search;
  return planOf(options);
}

// Fleischmann 2012, Table 6.1 and 5.3.3.
TEST(SppsoPlan, twoSoftStagesAreTheBaseConfiguration) {
  const SppsoPlan plan = planFor("two_soft");
  const auto& stages = stagesOf(plan);
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].particles, 10);
  EXPECT_EQ(stages[0].iterations, 20);
  EXPECT_EQ(stages[1].particles, 20);
  EXPECT_EQ(stages[1].iterations, 40);
  EXPECT_EQ(stages[0].reach.head<6>(), (Eigen::Matrix<double, 6, 1>::Ones()));
  EXPECT_EQ(stages[0].reach.tail<25>().norm(), 0.0);
  EXPECT_EQ(stages[1].reach[kPelvisTurn], 1.0);
  EXPECT_DOUBLE_EQ(stages[1].reach[kPelvisPlace + 2], 0.1);
  EXPECT_EQ(stages[1].reach[kLeftKnee], 1.0);
  EXPECT_EQ(stages[1].reach[kHeadTwist], 0.0);
  ASSERT_EQ(plan.edges.size(), 2u);
  EXPECT_EQ(plan.edges[0].cones, kTorsoOnly);
  EXPECT_EQ(plan.edges[1].cones, kAllButHead);
}

TEST(SppsoPlan, partitionsCostWhatTheThesisSays) {
  const auto evaluations = [](const char* search) {
    return dynamic_cast<const StagedSwarm&>(*planFor(search).optimiser).evaluations();
  };
  EXPECT_EQ(evaluations("two_soft"), 1000);
  EXPECT_EQ(evaluations("one_global"), 1000);
  EXPECT_EQ(evaluations("two_hard"), 1000);
  EXPECT_EQ(evaluations("three_soft"), 1000);
  EXPECT_EQ(evaluations("twelve_hard"), 7200);
}

TEST(SppsoPlan, hardStagesHoldWhatIsFoundAndMoveAllTheRest) {
  const SppsoPlan two = planFor("two_hard");
  EXPECT_EQ(stagesOf(two)[1].reach.head<6>().norm(), 0.0);
  const SppsoPlan plan = planFor("twelve_hard");
  ASSERT_EQ(stagesOf(plan).size(), 12u);
  EXPECT_EQ(plan.edges.size(), 12u);
  Eigen::VectorXd times = Eigen::VectorXd::Zero(kFleischmannParameters);
  for (const SwarmStage& stage : stagesOf(plan)) times += stage.reach;
  Eigen::VectorXd once = Eigen::VectorXd::Ones(kFleischmannParameters);
  once[kHeadTwist] = 0.0;
  EXPECT_EQ(times, once);
}

// Fleischmann 2012, 6.6: lower limbs are x9, x10, x13, x14, x19, x20, x25, x26.
TEST(SppsoPlan, threeSoftStagesScaleSigmaAsTheThesis) {
  const SppsoPlan plan = planFor("three_soft");
  const auto& stages = stagesOf(plan);
  for (const int x : {9, 10, 13, 14, 19, 20, 25, 26}) {
    EXPECT_EQ(stages[1].reach[x - 1], 0.0) << x;
    EXPECT_DOUBLE_EQ(stages[2].reach[x - 1], std::sqrt(2.0)) << x;
  }
  EXPECT_DOUBLE_EQ(stages[1].reach[kPelvisPlace], 0.1);
  EXPECT_DOUBLE_EQ(stages[2].reach[kPelvisTurn], 0.1);
  EXPECT_DOUBLE_EQ(stages[2].reach[kLeftHip], 0.5);
}

TEST(SppsoPlan, optionsChangeParticlesAndEdges) {
  SppsoOptions options;
  options.evaluations_factor = 2.0;
  options.last_particles = 40;
  options.last_iterations = 20;
  options.edges = false;
  options.torso_top = false;
  const SppsoPlan plan = planOf(options);
  EXPECT_EQ(stagesOf(plan)[0].particles, 20);
  EXPECT_EQ(stagesOf(plan)[1].particles, 80);
  EXPECT_EQ(stagesOf(plan)[1].iterations, 20);
  EXPECT_EQ(plan.edges[1].cones, 0u);
  EXPECT_FALSE(plan.edges[1].torso_top);
  options.search = "guess";
  EXPECT_NE(sentenceOf([&] { planOf(options); }).find("sppso/search"), std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
