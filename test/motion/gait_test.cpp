#include <gtest/gtest.h>

#include <cmath>

#include "error_text_of.h"
#include "motion/gait/foot_trajectory.h"
#include "motion/gait/gait_clearance.h"
#include "motion/gait/gait_swing.h"
#include "motion/motion_measures.h"

namespace markerless_mocap {
namespace {

const HumanSkeleton& person() {
  static const HumanSkeleton skeleton = HumanSkeleton::adult(1.75, 0.5);
  return skeleton;
}

MotionScript scriptOf(const std::string& seconds, const std::string& path) {
  return parseMotionScript(
      "{seconds: " + seconds + ", start: {x: 0.2, heading: 90}, path: [" + path + "], tracks: {}}",
      "test");
}

GaitPlan planOf(const MotionScript& script) {
  return planGait(script, GaitPath(script, 120.0), person());
}

TEST(GaitPath, standsWhereTheMovesEnd) {
  const MotionScript script = scriptOf("5", "{stand: 1}, {go: 1.57079633, turn: 90, seconds: 2}");
  const GaitPath path(script, 120.0);
  EXPECT_NEAR((path.at(0.2).position - Eigen::Vector2d(0.2, 0.0)).norm(), 0.0, 1e-6);
  // A quarter of a circle of 1 m radius to the left, begun facing +y.
  EXPECT_NEAR((path.at(4.5).position - Eigen::Vector2d(-0.8, 1.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(path.at(4.5).heading, M_PI, 1e-6);
  EXPECT_NEAR((path.at(2.1).position - path.at(1.9).position).norm(), 0.2 * M_PI / 4.0, 5e-3);
}

TEST(GaitPath, shiftsSidewaysWhileTurning) {
  const MotionScript script = scriptOf("4", "{shift: [0.0, 0.5], turn: -180, seconds: 2}");
  const GaitPath path(script, 120.0);
  EXPECT_NEAR((path.at(3.5).position - Eigen::Vector2d(-0.3, 0.0)).norm(), 0.0, 1e-6);
  EXPECT_NEAR(path.at(3.5).heading, -M_PI / 2, 1e-6);
}

TEST(GaitSteps, takesTheStepsThatAreAskedForInTurns) {
  const GaitPlan plan = planOf(scriptOf("6", "{stand: 1}, {go: 2, seconds: 3, steps: 5}"));
  ASSERT_EQ(plan.steps.size(), 5u);
  for (size_t i = 0; i < plan.steps.size(); ++i) {
    EXPECT_EQ(plan.steps[i].left, i % 2 == 1);
    EXPECT_LT(plan.steps[i].lift, plan.steps[i].land);
    if (i > 0) {
      EXPECT_GT(plan.steps[i].lift, plan.steps[i - 1].land) << "one foot stands";
    }
  }
}

TEST(GaitSteps, beginsWithTheFootThatIsAskedForOrLiesThere) {
  EXPECT_TRUE(planOf(scriptOf("4", "{go: 1, seconds: 2, first: left}")).steps.front().left);
  EXPECT_TRUE(planOf(scriptOf("4", "{shift: [0, 0.4], seconds: 2}")).steps.front().left);
  EXPECT_FALSE(planOf(scriptOf("4", "{shift: [0, -0.4], seconds: 2}")).steps.front().left);
}

TEST(GaitSteps, fasterWalkersTakeMoreAndLongerSteps) {
  const GaitPlan slow = planOf(scriptOf("6", "{go: 2, seconds: 4}"));
  const GaitPlan fast = planOf(scriptOf("6", "{go: 5, seconds: 4}"));
  EXPECT_GT(fast.steps.size(), slow.steps.size());
  const auto length = [](const GaitPlan& plan) {
    return (plan.steps[3].to.position - plan.steps[3].from.position).norm();
  };
  EXPECT_GT(length(fast), length(slow));
}

TEST(GaitSteps, runnersAreInTheAirBetweenSteps) {
  const GaitPlan plan = planOf(scriptOf("3", "{go: 2, seconds: 1, steps: 3, run: true}"));
  EXPECT_LT(plan.steps[1].lift, plan.steps[0].land);
}

TEST(GaitSteps, endsInTheStanceThatIsAskedFor) {
  const GaitPlan plan =
      planOf(scriptOf("6", "{go: 1, seconds: 2, steps: 4, width: 0.1, stagger: 0.2}"));
  const GroundPose &left = plan.steps[3].to, &right = plan.steps[2].to;
  const Eigen::Vector2d apart = left.position - right.position;  // heading +y
  EXPECT_NEAR(apart.y(), 0.2 * 1.75, 1e-3);
  EXPECT_NEAR(apart.x(), -0.1 * 1.75, 1e-3);
}

TEST(FootClearance, measuresFromHeelToToes) {
  const FootClearance clearance(person());
  const GroundPose foot{{1.0, 2.0}, M_PI / 2};
  EXPECT_NEAR(clearance.gap(foot, foot.shifted(0.0, 0.13)), 0.13, 1e-12);
  EXPECT_EQ(clearance.gap(foot, {foot.shifted(0.1, -0.02).position, 0.0}), 0.0) << "they cross";
  const double length = person().tailOf(Bone::kLeftToes).x() -
                        person().headOf(Bone::kLeftFoot).x() + 0.028 * person().stature;
  EXPECT_NEAR(clearance.gap(foot, foot.shifted(length + 0.07, 0.0)), 0.07, 1e-12);
}

TEST(FootClearance, putsAFootASideOfTheOtherOne) {
  const FootClearance clearance(person());
  const GroundPose other{{0.0, 0.0}, 0.0};
  const GroundPose free{{0.0, 0.15}, 0.0};
  EXPECT_EQ(clearance.beside(free, other).position, free.position);
  const GroundPose moved = clearance.beside({{0.0, 0.03}, 0.0}, other);
  EXPECT_NEAR(clearance.gap(moved, other), 0.056 * 1.75, 0.005);
  EXPECT_GT(moved.position.y(), 0.09);
}

TEST(FootClearance, goesRoundTheOtherFootOnItsOwnSide) {
  const FootClearance clearance(person());
  const GroundPose other{{0.0, 0.0}, 0.0};
  for (const bool left : {true, false}) {
    const GroundPose from{{-0.6, 0.02}, 0.0}, to{{0.6, -0.02}, 0.0};
    const Eigen::Vector2d detour = clearance.detour(left, from, to, other);
    EXPECT_EQ(detour.y() > 0.0, left);
    for (double u = 0.0; u <= 1.0; u += 0.05)
      EXPECT_GT(clearance.gap(swingPose(from, to, detour, u), other), 0.09) << u;
  }
  const GroundPose from{{-0.6, 0.2}, 0.0}, to{{0.6, 0.2}, 0.0};
  EXPECT_EQ(clearance.detour(true, from, to, other).norm(), 0.0) << "the way is free";
}

TEST(FootTrajectory, standsStillOnItsBallWhileTheHeelRises) {
  const MotionScript script = scriptOf("6", "{stand: 1}, {go: 3, seconds: 3}");
  const GaitPlan plan = planOf(script);
  const FootTrajectory track(script, plan, person(), true);
  const Eigen::Vector3d to_ball =
      person().headOf(Bone::kLeftToes) - person().headOf(Bone::kLeftFoot);
  const GaitStep& step = plan.steps[3];
  ASSERT_TRUE(step.left);
  const auto ball = [&](double t) -> Eigen::Vector3d {
    const FootPose pose = track.at(t);
    return pose.ankle + pose.foot * to_ball;
  };
  const Eigen::Vector3d planted = ball(step.lift - 0.05);
  EXPECT_GT(track.at(step.lift).ankle.z(), person().headOf(Bone::kLeftFoot).z() + 0.04);
  for (double t = step.lift - 0.2; t <= step.lift; t += 0.01)
    EXPECT_NEAR((ball(t) - planted).norm(), 0.0, 1e-9);
}

TEST(FootTrajectory, movesWithoutJumps) {
  const MotionScript script = scriptOf("6", "{stand: 1}, {go: 3, turn: 60, seconds: 3}");
  const FootTrajectory track(script, planOf(script), person(), false);
  for (double t = 0.0; t < 6.0; t += 0.001)
    EXPECT_LT((track.at(t + 0.001).ankle - track.at(t).ankle).norm(), 0.006) << t;
}

TEST(FootTrajectory, gesturesMayNotMeetSteps) {
  const MotionScript script = parseMotionScript(
      "{seconds: 4, start: {}, path: [{go: 1, seconds: 3}], tracks: {}, feet: [{foot: left, keys: "
      "[[1, 0, 0, 0, 0], [1.5, 0.1, 0, 0.1, 0], [2, 0, 0, 0, 0]]}]}",
      "kick.yaml");
  const std::string sentence = errorTextOf([&] { performMotion(script, person()); });
  EXPECT_EQ(sentence.find("kick.yaml/feet: the left foot's gesture"), 0u) << sentence;
}

}  // namespace
}  // namespace markerless_mocap
