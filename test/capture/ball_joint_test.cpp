#include "capture/truth/ball_joint.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d turned(const JointAxes& axes, const Vector3d& t) {
  return (AngleAxisd(t[0], axes[0]) * AngleAxisd(t[1], axes[1]) * AngleAxisd(t[2], axes[2]))
      .toRotationMatrix();
}

const JointAxes kShoulder = {-Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitZ()};
const JointAxes kHip = {-Vector3d::UnitZ(), Vector3d::UnitX(), -Vector3d::UnitY()};

TEST(BallJointTest, anglesGiveTheRotationBack) {
  for (const JointAxes& axes : {kShoulder, kHip})
    for (int i = 0; i < 400; ++i) {
      const Vector3d t(2.9 * std::sin(1.1 * i), 3.0 * std::sin(0.7 * i), 2.9 * std::sin(2.3 * i));
      const Vector3d found = ballAngles(turned(axes, t), axes, Vector3d::Zero(), -4, 4);
      EXPECT_LT((turned(axes, found) - turned(axes, t)).norm(), 1e-6) << t.transpose();
    }
}

TEST(BallJointTest, theSolutionWithinTheLimitsAndThenTheNearOneIsTaken) {
  const Vector3d t(0.3, 1.2, -0.8);
  EXPECT_LT((ballAngles(turned(kShoulder, t), kShoulder, Vector3d::Zero(), -0.7, 3.3) - t).norm(),
            1e-9);
  const Vector3d other(0.3 - M_PI, -1.2, -0.8 + M_PI);
  EXPECT_LT((ballAngles(turned(kShoulder, t), kShoulder, other, -2, 2) - other).norm(), 1e-9);
  EXPECT_LT((ballAngles(turned(kShoulder, t), kShoulder, other, 0, 3) - t).norm(), 1e-9);
}

TEST(BallJointTest, whereTwoAxesFallTogetherTheFirstAngleStays) {
  const Vector3d hanging(0.4, 0.0, 0.0);
  const Vector3d found =
      ballAngles(turned(kShoulder, hanging), kShoulder, Vector3d(1.0, 0, 0.5), -0.7, 3.3);
  EXPECT_NEAR(found[0], 1.0, 1e-9);
  EXPECT_LT((turned(kShoulder, found) - turned(kShoulder, hanging)).norm(), 1e-9);
}

TEST(BallJointTest, twoAxesAimADirection) {
  const Vector3d rests[] = {Vector3d::UnitY(), -Vector3d::UnitY()};
  for (const Vector3d& rest : rests) {
    const Vector3d first = -Vector3d::UnitZ(), second = Vector3d::UnitX();
    const Vector3d wanted = (rest + Vector3d(0.4, 0.0, -0.3)).normalized();
    const Eigen::Vector2d t = aimingAngles(first, second, rest, wanted);
    EXPECT_LT((AngleAxisd(t[0], first) * AngleAxisd(t[1], second) * rest - wanted).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace markerless_mocap
