#include "markerless_mocap/capture/body_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "capture/studio_fixture.h"

namespace markerless_mocap {
namespace {

class BodyMotionTest : public ::testing::Test {
 protected:
  LinkPoses posesAt(double seconds) {
    const BodyState state = motion_.at(seconds);
    LinkPoses poses;
    model_->forwardKinematics(state.T_world_body, state.angles, poses);
    return poses;
  }
  Eigen::Vector3d origin(const std::string& link, double seconds) {
    return posesAt(seconds)[model_->linkIndex(link)].translation();
  }
  double lowest(const LinkPoses& poses, const std::string& link) {
    double z = 1e9;
    for (const RoundCone& cone : model_->shape())
      if (link.empty() || cone.link == model_->linkIndex(link))
        z = std::min({z, (poses[cone.link] * cone.a).z() - cone.radius_a,
                      (poses[cone.link] * cone.b).z() - cone.radius_b});
    return z;
  }

  const std::shared_ptr<const BodyModel> model_ = human();
  const WalkAndWave motion_{model_, 0.5, 0.6};
};

TEST_F(BodyMotionTest, lowestFootTouchesTheFloor) {
  for (double t = 0; t < WalkAndWave::period(); t += 0.11) {
    const LinkPoses poses = posesAt(t);
    EXPECT_NEAR(lowest(poses, ""), 0.0, 1e-9) << t;
    const double left = lowest(poses, "l_ankle"), right = lowest(poses, "r_ankle");
    EXPECT_NEAR(std::min(left, right), 0.0, 0.03) << t;
    EXPECT_LT(std::max(left, right), 0.35) << t;
  }
}

TEST_F(BodyMotionTest, bothFeetLeaveTheFloorInTurn) {
  double left = 0, right = 0;
  for (double t = 0; t < 2.5; t += 0.05) {
    const LinkPoses poses = posesAt(t);
    left = std::max(left, lowest(poses, "l_ankle"));
    right = std::max(right, lowest(poses, "r_ankle"));
  }
  EXPECT_GT(left, 0.04);
  EXPECT_NEAR(left, right, 0.02);
}

TEST_F(BodyMotionTest, anglesStayStrictlyWithinTheLimits) {
  for (double t = 0; t < 2 * WalkAndWave::period(); t += 0.07) {
    const BodyState state = motion_.at(t);
    for (const BodyJoint& joint : model_->joints()) {
      if (joint.angle_index < 0) continue;
      const double angle = state.angles[joint.angle_index];
      if (angle == 0.0) continue;  // at rest; the elbows' and knees' limit is 0
      EXPECT_GT(angle, joint.lower) << joint.name << " at " << t;
      EXPECT_LT(angle, joint.upper) << joint.name << " at " << t;
    }
  }
}

TEST_F(BodyMotionTest, movesSmoothlyAlsoFromRoundToRound) {
  constexpr double kStep = 0.01, kFastest = 8.0;  // s, rad/s
  const double start = WalkAndWave::period() - 3.0;
  for (double t = start; t < start + WalkAndWave::period(); t += kStep) {
    const BodyState now = motion_.at(t), next = motion_.at(t + kStep);
    EXPECT_LT((next.angles - now.angles).cwiseAbs().maxCoeff(), kFastest * kStep) << t;
    EXPECT_LT((next.T_world_body.translation() - now.T_world_body.translation()).norm(),
              2.0 * kStep)
        << t;
  }
}

TEST_F(BodyMotionTest, walksForwardInItsCircleAtItsSpeed) {
  for (double t = 0; t < 12; t += 0.9) {
    const Eigen::Isometry3d now = motion_.at(t).T_world_body;
    const Eigen::Vector3d step =
        motion_.at(t + 0.01).T_world_body.translation() - now.translation();
    EXPECT_NEAR(now.translation().head<2>().norm(), 0.5, 1e-9);
    EXPECT_NEAR(step.dot(now.linear().col(0)), 0.006, 2e-4) << t;
  }
}

TEST_F(BodyMotionTest, gesturesAreWhatTheyAreCalled) {
  const double head_waving = origin("head", 6.5).z();
  EXPECT_GT(origin("r_wrist", 6.5).z(), head_waving - 0.15);
  EXPECT_LT(origin("l_wrist", 6.5).z(), origin("l_shoulder", 6.5).z() - 0.2);
  const Eigen::Vector3d span = origin("l_wrist", 10.5) - origin("r_wrist", 10.5);
  EXPECT_GT(span.norm(), 1.2);
  for (const char* wrist : {"l_wrist", "r_wrist"})
    EXPECT_GT(origin(wrist, 14.5).z(), origin("head", 14.5).z());
}

TEST_F(BodyMotionTest, armsAreFreeOfTheTrunkMostOfTheTime) {
  int free = 0, all = 0;
  for (double t = 0; t < WalkAndWave::period(); t += 0.1) {
    const LinkPoses poses = posesAt(t);
    const Eigen::Isometry3d T_body_world = poses[0].inverse();
    double nearest = 1e9;
    for (const char* link : {"l_wrist", "r_wrist", "l_elbow", "r_elbow"}) {
      const Eigen::Vector3d p = T_body_world * poses[model_->linkIndex(link)].translation();
      nearest = std::min(nearest, p.head<2>().norm());
    }
    free += nearest > 0.27;
    ++all;
  }
  EXPECT_GT(free, 0.8 * all);
}

TEST_F(BodyMotionTest, walkWithoutRadiusIsRefused) {
  EXPECT_EQ(sentenceOf([&] { WalkAndWave(model_, 0.0, 1.0); }),
            "the walk needs a radius above 0 m and a speed not below 0 m/s");
}

}  // namespace
}  // namespace markerless_mocap
