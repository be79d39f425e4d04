#include "numerics/shortest_rotation.h"

#include <gtest/gtest.h>

#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

TEST(ShortestRotation, TurnsOneDirectionToTheOtherAboutTheirNormal) {
  const Vector3d from(2.0, 0.0, 0.0), to(0.0, 0.5, 0.5 * std::sqrt(3.0));
  const Eigen::AngleAxisd turn(shortestRotation(from, to));
  EXPECT_NEAR(turn.angle(), M_PI / 2, 1e-12);
  EXPECT_TRUE(turn.axis().isApprox(from.cross(to).normalized(), 1e-12));
}

TEST(ShortestRotation, OppositeDirectionsAreTurnedByHalfATurn) {
  const Vector3d from(0.3, -0.4, 1.2);
  const Eigen::Quaterniond turn = shortestRotation(from, -2.0 * from);
  EXPECT_TRUE((turn * from).isApprox(-from, 1e-7));
  EXPECT_NEAR(turn.norm(), 1.0, 1e-12);
}

}  // namespace
}  // namespace markerless_mocap
