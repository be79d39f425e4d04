#include "motion/skeleton/two_bone_ik.h"

#include <gtest/gtest.h>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

TEST(LimbIk, reachesTargetsExactlyWithUnchangedBones) {
  const Vector3d root(0.1, -0.2, 0.9);
  for (const Vector3d& target :
       {Vector3d(0.3, -0.1, 0.3), Vector3d(-0.2, 0.1, 0.4), Vector3d(0.1, -0.2, 0.2)}) {
    const TwoBoneIkResult bend = solveTwoBoneIk(root, target, 0.43, 0.41, Vector3d::UnitX(), 2.6);
    EXPECT_NEAR((bend.end - target).norm(), 0.0, 1e-12);
    EXPECT_NEAR((bend.middle - root).norm(), 0.43, 1e-12);
    EXPECT_NEAR((bend.end - bend.middle).norm(), 0.41, 1e-12);
    EXPECT_GT((bend.middle - 0.5 * (root + target)).x(), 0.0) << "bends towards the pole";
  }
}

TEST(LimbIk, stretchesTowardsWhatIsTooFar) {
  const TwoBoneIkResult bend =
      solveTwoBoneIk(Vector3d::Zero(), Vector3d(0, 0, -2), 0.4, 0.5, Vector3d::UnitX(), 2.6);
  EXPECT_NEAR((bend.end - Vector3d(0, 0, -0.9)).norm(), 0.0, 1e-12);
  EXPECT_NEAR((bend.middle - Vector3d(0, 0, -0.4)).norm(), 0.0, 1e-12);
}

TEST(LimbIk, bendsNoFurtherThanAllowed) {
  const TwoBoneIkResult bend = solveTwoBoneIk(Vector3d::Zero(), Vector3d(0, 0, -0.01), 0.4, 0.4,
                                              Vector3d::UnitX(), M_PI / 2);
  EXPECT_NEAR(bend.end.norm(), 0.4 * std::sqrt(2.0), 1e-12);
  EXPECT_NEAR((bend.end - bend.middle).dot(bend.middle), 0.0, 1e-12);
}

TEST(LimbIk, easedTargetYieldsOnlyNearTheEnd) {
  const Vector3d root(1, 1, 1), way = Vector3d(1, 2, -2) / 3.0;
  EXPECT_EQ(softIkTarget(root, root + 0.98 * way, 1.0), root + 0.98 * way);
  EXPECT_NEAR((softIkTarget(root, root + 5.0 * way, 1.0) - root).norm(), 0.9995, 1e-6);
  double last = 0.97;
  for (double d = 0.98; d < 1.2; d += 0.001) {
    const double reached = (softIkTarget(root, root + d * way, 1.0) - root).norm();
    EXPECT_GE(reached, last - 1e-12);
    EXPECT_LE(reached, d + 1e-12);
    last = reached;
  }
}

TEST(LimbIk, turnsBoneAndHingeTogether) {
  const Vector3d to(0.2, 0.5, -0.7), hinge(0.1, 0.9, 0.2);
  const Eigen::Quaterniond turn =
      turnWithHinge(Vector3d(0.01, 0, -1), Vector3d::UnitY(), to, hinge);
  EXPECT_NEAR((turn * Vector3d(0.01, 0, -1).normalized() - to.normalized()).norm(), 0.0, 1e-12);
  const Vector3d turned = turn * Vector3d::UnitY();
  EXPECT_NEAR(turned.dot(to.cross(hinge)), 0.0, 1e-12) << "in the plane of bone and hinge";
  EXPECT_GT(turned.dot(hinge), 0.0);
}

}  // namespace
}  // namespace markerless_mocap
