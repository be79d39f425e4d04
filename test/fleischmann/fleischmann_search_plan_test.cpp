#include "fleischmann/search/fleischmann_search_plan.h"

#include <gtest/gtest.h>

#include <cmath>

#include "error_text_of.h"
#include "optimisation/staged_swarm.h"

namespace markerless_mocap {
namespace {

const std::vector<SwarmStage>& stagesOf(const FleischmannSearchPlan& plan) {
  return dynamic_cast<const StagedSwarm&>(*plan.optimiser).stages();
}

FleischmannSearchPlan planFor(const std::string& search) {
  FleischmannOptions options;
  options.search = search;
  return makeSearchPlan(options);
}

// Fleischmann 2012, Table 6.1 and 5.3.3.
TEST(FleischmannSearchPlan, twoSoftStagesAreTheBaseConfiguration) {
  const FleischmannSearchPlan plan = planFor("two_soft");
  const auto& stages = stagesOf(plan);
  ASSERT_EQ(stages.size(), 2u);
  EXPECT_EQ(stages[0].particles, 10);
  EXPECT_EQ(stages[0].iterations, 20);
  EXPECT_EQ(stages[1].particles, 20);
  EXPECT_EQ(stages[1].iterations, 40);
  EXPECT_EQ(stages[0].sigma_scale.head<6>(), (Eigen::Matrix<double, 6, 1>::Ones()));
  EXPECT_EQ(stages[0].sigma_scale.tail<25>().norm(), 0.0);
  EXPECT_EQ(stages[1].sigma_scale[kPelvisOrientation], 1.0);
  EXPECT_DOUBLE_EQ(stages[1].sigma_scale[kPelvisPosition + 2], 0.1);
  EXPECT_EQ(stages[1].sigma_scale[kLeftKnee], 1.0);
  EXPECT_EQ(stages[1].sigma_scale[kHeadTwist], 0.0);
  ASSERT_EQ(plan.edges.size(), 2u);
  EXPECT_EQ(plan.edges[0].cones, kTorsoOnly);
  EXPECT_EQ(plan.edges[1].cones, kAllButHead);
}

TEST(FleischmannSearchPlan, partitionsCostWhatTheThesisSays) {
  const auto evaluations = [](const char* search) {
    return dynamic_cast<const StagedSwarm&>(*planFor(search).optimiser).evaluations();
  };
  EXPECT_EQ(evaluations("two_soft"), 1000);
  EXPECT_EQ(evaluations("one_global"), 1000);
  EXPECT_EQ(evaluations("two_hard"), 1000);
  EXPECT_EQ(evaluations("three_soft"), 1000);
  EXPECT_EQ(evaluations("twelve_hard"), 7200);
}

TEST(FleischmannSearchPlan, hardStagesHoldWhatIsFoundAndMoveAllTheRest) {
  const FleischmannSearchPlan two = planFor("two_hard");
  EXPECT_EQ(stagesOf(two)[1].sigma_scale.head<6>().norm(), 0.0);
  const FleischmannSearchPlan plan = planFor("twelve_hard");
  ASSERT_EQ(stagesOf(plan).size(), 12u);
  EXPECT_EQ(plan.edges.size(), 12u);
  Eigen::VectorXd times = Eigen::VectorXd::Zero(kFleischmannParameterCount);
  for (const SwarmStage& stage : stagesOf(plan)) times += stage.sigma_scale;
  Eigen::VectorXd once = Eigen::VectorXd::Ones(kFleischmannParameterCount);
  once[kHeadTwist] = 0.0;
  EXPECT_EQ(times, once);
}

// Fleischmann 2012, 6.6: lower limbs are x9, x10, x13, x14, x19, x20, x25, x26.
TEST(FleischmannSearchPlan, threeSoftStagesScaleSigmaAsTheThesis) {
  const FleischmannSearchPlan plan = planFor("three_soft");
  const auto& stages = stagesOf(plan);
  for (const int x : {9, 10, 13, 14, 19, 20, 25, 26}) {
    EXPECT_EQ(stages[1].sigma_scale[x - 1], 0.0) << x;
    EXPECT_DOUBLE_EQ(stages[2].sigma_scale[x - 1], std::sqrt(2.0)) << x;
  }
  EXPECT_DOUBLE_EQ(stages[1].sigma_scale[kPelvisPosition], 0.1);
  EXPECT_DOUBLE_EQ(stages[2].sigma_scale[kPelvisOrientation], 0.1);
  EXPECT_DOUBLE_EQ(stages[2].sigma_scale[kLeftHip], 0.5);
}

TEST(FleischmannSearchPlan, optionsChangeParticlesAndEdges) {
  FleischmannOptions options;
  options.particle_factor = 2.0;
  options.swarm.final_stage_particles = 40;
  options.swarm.final_stage_iterations = 20;
  options.use_edges = false;
  options.use_torso_top_edge = false;
  const FleischmannSearchPlan plan = makeSearchPlan(options);
  EXPECT_EQ(stagesOf(plan)[0].particles, 20);
  EXPECT_EQ(stagesOf(plan)[1].particles, 80);
  EXPECT_EQ(stagesOf(plan)[1].iterations, 20);
  EXPECT_EQ(plan.edges[1].cones, 0u);
  EXPECT_FALSE(plan.edges[1].torso_top);
  options.search = "guess";
  EXPECT_NE(errorTextOf([&] { makeSearchPlan(options); }).find("pose_fitting/fleischmann/search"),
            std::string::npos);
}

}  // namespace
}  // namespace markerless_mocap
