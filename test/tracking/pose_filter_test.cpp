#include "markerless_mocap/tracking/pose_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "body/body_fixture.h"
#include "error_text_of.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr int64_t kSecond = 1000000000;
constexpr int64_t kFrame = kSecond / 30;

class PoseFilterTest : public ::testing::Test {
 protected:
  PoseFilterTest() {
    options_.cutoff = 1.0;
    options_.beta = 2.0;
  }

  PoseFilter filter() const { return {testBody(), options_}; }

  static BodyPose poseWith(const std::string& joint, double angle,
                           const Vector3d& position = Vector3d(1.0, 2.0, 1.0)) {
    BodyPose pose;
    pose.status = PoseStatus::kTracked;
    pose.T_world_body.translation() = position;
    pose.angles = Eigen::VectorXd::Constant(testBody()->angleCount(), 0.1);
    pose.angles[testBody()->angleIndex(joint)] = angle;
    return pose;
  }
  static double angleIn(const BodyPose& pose, const std::string& joint) {
    return pose.angles[testBody()->angleIndex(joint)];
  }
  static bool same(const BodyPose& a, const BodyPose& b) {
    return a.status == b.status && a.angles == b.angles &&
           a.T_world_body.matrix() == b.T_world_body.matrix();
  }
  /// Two instants of the elbow in motion; at 2 * kFrame the filter would not give out its input.
  static PoseFilter movedTwice(PoseFilter filter) {
    filter.filtered(0, poseWith("l_elbow", 0.5));
    filter.filtered(kFrame, poseWith("l_elbow", 0.6));
    return filter;
  }

  FilterOptions options_;
};

TEST_F(PoseFilterTest, FirstOutputIsTheInputAndConstantInputStays) {
  PoseFilter filter = this->filter();
  BodyPose pose = poseWith("l_elbow", 0.7);
  pose.T_world_body.linear() = AngleAxisd(2.0, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_TRUE(same(filter.filtered(0, pose), pose));
  for (int k = 1; k < 20; ++k) {
    const BodyPose out = filter.filtered(k * kFrame, pose);
    EXPECT_TRUE(out.T_world_body.isApprox(pose.T_world_body, 1e-12)) << k;
    EXPECT_TRUE(out.angles.isApprox(pose.angles, 1e-12)) << k;
  }
}

TEST_F(PoseFilterTest, WhatIsNotFilteredIsHandedOn) {
  BodyPose pose = poseWith("l_elbow", 0.7);
  pose.reason = "an arm is not seen";
  pose.part_seen = {true, true, false, true, true, true};
  pose.part_sigma_m[1] = 0.02;
  pose.silhouette_overlap = 0.9;
  const BodyPose out = movedTwice(filter()).filtered(2 * kFrame, pose);
  EXPECT_EQ(out.reason, pose.reason);
  EXPECT_EQ(out.part_seen, pose.part_seen);
  EXPECT_EQ(out.part_sigma_m[1], 0.02);
  EXPECT_EQ(out.silhouette_overlap, 0.9);
}

// Cutoff 1 Hz, 2 Hz per unit of speed; a share is 2 pi f dt / (1 + 2 pi f dt). Step of 0.4 within
// 0.1 s, share of the trend 0.71537: v 2.86146, cutoff 6.72292, share 0.80858, predicted 0.28615.
// Then 0.05 s at rest, share of the trend 0.55686: v 1.26802, cutoff 3.53604, share 0.52627.
TEST_F(PoseFilterTest, StepFollowsTheEquationsAtIrregularTimes) {
  PoseFilter filter = this->filter(), position_filter = this->filter();
  const auto angle_after = [&](int64_t stamp_ns, double angle) {
    return angleIn(filter.filtered(stamp_ns, poseWith("l_elbow", angle)), "l_elbow");
  };
  const auto height_after = [&](int64_t stamp_ns, double height) {
    return position_filter.filtered(stamp_ns, poseWith("l_elbow", 0.1, Vector3d(0.0, 0.0, height)))
        .T_world_body.translation()
        .z();
  };
  for (int64_t k = 0; k < 3; ++k) {
    EXPECT_NEAR(angle_after(k * kSecond / 10, 0.5), 0.5, 1e-12);
    EXPECT_NEAR(height_after(k * kSecond / 10, 0.5), 0.5, 1e-12);
  }
  EXPECT_NEAR(angle_after(3 * kSecond / 10, 0.9), 0.5 + 0.378206, 1e-5);
  EXPECT_NEAR(height_after(3 * kSecond / 10, 0.9), 0.5 + 0.378206, 1e-5);
  EXPECT_NEAR(angle_after(7 * kSecond / 20, 0.9), 0.5 + 0.419711, 1e-5);
  EXPECT_NEAR(height_after(7 * kSecond / 20, 0.9), 0.5 + 0.419711, 1e-5);
}

TEST_F(PoseFilterTest, SteadyMotionIsNotLateAndAStartHardly) {
  PoseFilter filter = this->filter();
  double largest = 0.0, last = 0.0;
  for (int k = 0; k < 90; ++k) {
    const double x = std::max(0, k - 30) / 30.0;  // from rest to 1 m/s at once
    const BodyPose raw = poseWith("l_elbow", 0.1, Vector3d(x, 0.0, 1.0));
    last = x - filter.filtered(k * kFrame, raw).T_world_body.translation().x();
    largest = std::max(largest, std::abs(last));
  }
  EXPECT_GT(largest, 1e-3);
  EXPECT_LT(largest, 1.0 / (2.0 * M_PI * options_.cutoff));
  EXPECT_NEAR(last, 0.0, 1e-6);
}

TEST_F(PoseFilterTest, FastestCoordinateSetsTheCutoffOfTheWholeBody) {
  PoseFilter calm = filter(), quick = filter();
  const auto step = [](PoseFilter* filter, int64_t stamp_ns, double elbow, double knee) {
    BodyPose raw = poseWith("l_elbow", elbow);
    raw.angles[testBody()->angleIndex("l_knee")] = knee;
    return angleIn(filter->filtered(stamp_ns, raw), "l_elbow");
  };
  for (int64_t k = 0; k < 3; ++k) {
    step(&calm, k * kFrame, 0.5, 0.1);
    step(&quick, k * kFrame, 0.5, 0.1);
  }
  const double calm_error = 0.51 - step(&calm, 3 * kFrame, 0.51, 0.1);
  const double quick_error = 0.51 - step(&quick, 3 * kFrame, 0.51, 0.4);
  EXPECT_GT(quick_error, 0.0);
  EXPECT_GT(calm_error, 2.0 * quick_error);
}

TEST_F(PoseFilterTest, TurningRootStaysOnTheShortestWay) {
  PoseFilter filter = this->filter();
  for (int k = 0; k < 150; ++k) {
    BodyPose raw = poseWith("l_elbow", 0.1);
    const double yaw = std::remainder(0.1 * k + 0.02 * std::sin(2.1 * k), 2.0 * M_PI);
    raw.T_world_body.linear() = AngleAxisd(yaw, Vector3d::UnitZ()).toRotationMatrix();
    const BodyPose out = filter.filtered(k * kFrame, raw);
    const AngleAxisd off(raw.T_world_body.linear().transpose() * out.T_world_body.linear());
    EXPECT_LT(std::abs(std::remainder(off.angle(), 2.0 * M_PI)), 0.03) << k;
    EXPECT_GT(out.T_world_body.linear()(2, 2), 1.0 - 1e-9) << k;
  }
}

TEST_F(PoseFilterTest, AnglesGoTheShortestWayAndKeepWithinLimits) {
  PoseFilter filter = this->filter();
  const BodyJoint& joint = testBody()->joint("l_y_shoulder");
  ASSERT_LT(joint.upper, 3.2);
  double largest = 0.0;
  for (int k = 0; k < 60; ++k) {
    const double raw = std::remainder(2.5 + 0.02 * k + 0.02 * std::sin(2.1 * k), 2.0 * M_PI);
    const double out =
        angleIn(filter.filtered(k * kFrame, poseWith("l_y_shoulder", raw)), "l_y_shoulder");
    EXPECT_LE(out, joint.upper) << k;
    EXPECT_GE(out, joint.lower) << k;
    largest = std::max(largest, std::abs(std::remainder(out - raw, 2.0 * M_PI)));
  }
  EXPECT_LT(largest, 0.03);
}

TEST_F(PoseFilterTest, OvershootEndsAtALimitUnlessTheInputIsBeyondIt) {
  PoseFilter filter = this->filter();
  double elbow = 1.0, shoulder = 1.0;
  for (int k = 0; k < 20; ++k) {
    const double angle = std::max(0.0, 1.0 - 0.1 * k);  // the elbow's lower limit is 0
    BodyPose raw = poseWith("l_elbow", angle);
    raw.angles[testBody()->angleIndex("l_y_shoulder")] = angle;
    const BodyPose out = filter.filtered(k * kFrame, raw);
    elbow = std::min(elbow, angleIn(out, "l_elbow"));
    shoulder = std::min(shoulder, angleIn(out, "l_y_shoulder"));
  }
  EXPECT_LT(shoulder, -0.005);
  EXPECT_EQ(elbow, 0.0);
  const BodyPose beyond = poseWith("l_elbow", -0.2);
  for (int k = 20; k < 60; ++k) elbow = angleIn(filter.filtered(k * kFrame, beyond), "l_elbow");
  EXPECT_NEAR(elbow, -0.2, 1e-3);
}

TEST_F(PoseFilterTest, LostPoseGoesOutAsLostAndTheNextOneIsRaw) {
  PoseFilter filter = movedTwice(this->filter());
  BodyPose lost;
  lost.reason = "nobody is there";
  const BodyPose out = filter.filtered(2 * kFrame, lost);
  EXPECT_EQ(out.status, PoseStatus::kLost);
  EXPECT_EQ(out.reason, "nobody is there");
  EXPECT_EQ(out.angles.size(), 0);
  const BodyPose again = poseWith("l_elbow", 0.65);
  EXPECT_TRUE(same(filter.filtered(3 * kFrame, again), again));
}

TEST_F(PoseFilterTest, BeginsAnewWithAPoseThatDoesNotFollow) {
  const BodyPose near = poseWith("l_elbow", 0.65), far = poseWith("l_elbow", 0.6 + 1.6);
  BodyPose found = near, turned = near;
  found.status = PoseStatus::kReinitialized;
  turned.T_world_body.linear() = AngleAxisd(1.6, Vector3d::UnitX()).toRotationMatrix();
  EXPECT_FALSE(same(movedTwice(filter()).filtered(2 * kFrame, near), near));
  EXPECT_TRUE(same(movedTwice(filter()).filtered(2 * kFrame, found), found));
  EXPECT_TRUE(same(movedTwice(filter()).filtered(2 * kFrame, far), far));
  EXPECT_TRUE(same(movedTwice(filter()).filtered(2 * kFrame, turned), turned));
  EXPECT_TRUE(same(movedTwice(filter()).filtered(kFrame, near), near));
  EXPECT_TRUE(same(movedTwice(filter()).filtered(0, near), near));
  EXPECT_FALSE(same(movedTwice(filter()).filtered(kFrame + kSecond / 2, near), near));
  EXPECT_TRUE(same(movedTwice(filter()).filtered(kFrame + kSecond / 2 + 1000, near), near));
}

TEST_F(PoseFilterTest, JitterIsReducedAtRestAndInMotionAndSoIsTheError) {
  for (const double speed : {0.0, 0.5}) {
    PoseFilter filter(testBody(), FilterOptions());
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.01);
    std::vector<Vector3d> raw_way, way;
    double raw_error = 0.0, error = 0.0;
    for (int k = 0; k < 300; ++k) {
      const Vector3d truth(speed * k / 30.0, 0.0, 1.0);
      const BodyPose raw =
          poseWith("l_elbow", 0.5, truth + Vector3d(noise(random), noise(random), noise(random)));
      raw_way.push_back(raw.T_world_body.translation());
      way.push_back(filter.filtered(k * kFrame, raw).T_world_body.translation());
      raw_error += (raw_way.back() - truth).norm();
      error += (way.back() - truth).norm();
    }
    double raw_jitter = 0.0, jitter = 0.0;
    for (size_t k = 2; k < way.size(); ++k) {
      raw_jitter += (raw_way[k] - 2.0 * raw_way[k - 1] + raw_way[k - 2]).norm();
      jitter += (way[k] - 2.0 * way[k - 1] + way[k - 2]).norm();
    }
    EXPECT_LT(jitter, 0.75 * raw_jitter) << speed;
    EXPECT_LT(error, raw_error) << speed;
  }
}

TEST_F(PoseFilterTest, RefusesAnglesOfAnotherBodyAndOptionsOutOfRange) {
  BodyPose pose = poseWith("l_elbow", 0.5);
  pose.angles.conservativeResize(3);
  EXPECT_NE(errorTextOf([&] { filter().filtered(0, pose); }).find("joint angles, 3 were given"),
            std::string::npos);
  options_.cutoff = 0.0;
  EXPECT_NE(errorTextOf([&] { filter(); }).find("pose_fitting/filter/cutoff is 0"),
            std::string::npos);
}

TEST_F(PoseFilterTest, OptionSaysWhetherThereIsOne) {
  EXPECT_TRUE(makePoseFilter(testBody(), options_));
  options_.enabled = false;
  EXPECT_FALSE(makePoseFilter(testBody(), options_));
}

}  // namespace
}  // namespace markerless_mocap
