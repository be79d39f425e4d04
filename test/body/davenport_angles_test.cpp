#include "body/davenport_angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using Axes = std::array<Vector3d, 3>;

Matrix3d turned(const Axes& axes, const Vector3d& t) {
  return (AngleAxisd(t[0], axes[0]) * AngleAxisd(t[1], axes[1]) * AngleAxisd(t[2], axes[2]))
      .toRotationMatrix();
}

const Axes kShoulder = {-Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitZ()};
const Axes kHip = {-Vector3d::UnitZ(), Vector3d::UnitX(), -Vector3d::UnitY()};

TEST(DavenportAnglesTest, anglesGiveTheRotationBack) {
  for (const Axes& axes : {kShoulder, kHip})
    for (int i = 0; i < 400; ++i) {
      const Vector3d t(2.9 * std::sin(1.1 * i), 3.0 * std::sin(0.7 * i), 2.9 * std::sin(2.3 * i));
      const Vector3d found = davenportAngles(turned(axes, t), axes, Vector3d::Zero(), -4, 4);
      EXPECT_LT((turned(axes, found) - turned(axes, t)).norm(), 1e-6) << t.transpose();
    }
}

TEST(DavenportAnglesTest, theSolutionWithinTheLimitsAndThenTheNearOneIsTaken) {
  const Vector3d t(0.3, 1.2, -0.8);
  EXPECT_LT(
      (davenportAngles(turned(kShoulder, t), kShoulder, Vector3d::Zero(), -0.7, 3.3) - t).norm(),
      1e-9);
  const Vector3d other(0.3 - M_PI, -1.2, -0.8 + M_PI);
  EXPECT_LT((davenportAngles(turned(kShoulder, t), kShoulder, other, -2, 2) - other).norm(), 1e-9);
  const Vector3d near(other[0] + 0.1, other[1], other[2] - 0.1);  // half a turn off would be a tie
  EXPECT_LT((davenportAngles(turned(kShoulder, t), kShoulder, near, 0, 3) - t).norm(), 1e-9);
}

TEST(DavenportAnglesTest, whereTwoAxesFallTogetherTheFirstAngleStays) {
  const Vector3d hanging(0.4, 0.0, 0.0);
  const Vector3d found =
      davenportAngles(turned(kShoulder, hanging), kShoulder, Vector3d(1.0, 0, 0.5), -0.7, 3.3);
  EXPECT_NEAR(found[0], 1.0, 1e-9);
  EXPECT_LT((turned(kShoulder, found) - turned(kShoulder, hanging)).norm(), 1e-9);
}

TEST(DavenportAnglesTest, holdsTheFirstAngleWhereOnlyTheSumIsDefined) {
  const std::array<Vector3d, 3> zxz = {Vector3d::UnitZ(), Vector3d::UnitX(), Vector3d::UnitZ()};
  const Matrix3d R = AngleAxisd(0.9, Vector3d::UnitZ()).toRotationMatrix();
  const Vector3d t = davenportAngles(R, zxz, Vector3d(0.4, 0.0, 0.0), -1.0, 1.0);
  EXPECT_NEAR(t[0], 0.4, 1e-9);
  EXPECT_NEAR(t[1], 0.0, 1e-9);
  EXPECT_NEAR(t[2], 0.5, 1e-9);
}

}  // namespace
}  // namespace markerless_mocap
