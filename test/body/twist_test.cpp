#include "markerless_mocap/body/twist.h"

#include <gtest/gtest.h>

#include <cmath>

namespace markerless_mocap {
namespace {

TEST(TwistTest, exponentialTurnsAboutTheAxisThroughThePoint) {
  for (const double angle : {-3.0, -0.4, 0.0, 1e-9, 0.3, 3.1}) {
    const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -1.0, 2.0).normalized(), point(0.5, 0.2, -1);
    const Eigen::Isometry3d expected =
        Eigen::Translation3d(point) * Eigen::AngleAxisd(angle, axis) * Eigen::Translation3d(-point);
    const Eigen::Isometry3d motion = exponential(Twist::revolute(axis, point), angle);
    EXPECT_TRUE(motion.isApprox(expected, 1e-12)) << angle;
    EXPECT_TRUE((motion * point).isApprox(point, 1e-12)) << angle;
  }
}

TEST(TwistTest, quarterTurnAboutZWorkedByHand) {
  const Twist twist = Twist::revolute({0, 0, 1}, {1, 0, 0});
  EXPECT_TRUE(twist.v.isApprox(Eigen::Vector3d(0, -1, 0)));
  const Eigen::Isometry3d motion = exponential(twist, std::acos(-1.0) / 2);
  EXPECT_TRUE((motion * Eigen::Vector3d(2, 0, 5)).isApprox(Eigen::Vector3d(1, 1, 5), 1e-12));
}

}  // namespace
}  // namespace markerless_mocap
