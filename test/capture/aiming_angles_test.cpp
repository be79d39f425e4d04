#include "capture/truth/aiming_angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

TEST(AimingAnglesTest, twoAxesAimADirection) {
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
