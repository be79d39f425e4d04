#include "contour/track/default_postures.h"

#include <gtest/gtest.h>

#include "contour/model/contour_body.h"

namespace markerless_mocap {
namespace {

// Of contourPointNames().
constexpr Eigen::Index kPelvis = 0, kHead = 2, kLeftWrist = 5, kLeftKnee = 10, kLeftAnkle = 11;

/// Two voxels, half a metre to both sides of (1, 2, 0.8).
VisualHull hullAbout() {
  VisualHull hull;
  hull.lattice.origin = Eigen::Vector3d(0.0, 1.5, 0.3);
  hull.lattice.pitch = 1.0;
  hull.lattice.size = {2, 1, 1};
  hull.voxels.resize(2);
  hull.voxels[1].index = 1;
  return hull;
}

class CommonPosturesTest : public testing::Test {
 protected:
  Eigen::Matrix3Xd points(size_t pose) const { return body.points(poses.at(pose)); }

  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  std::vector<ContourPose> poses = defaultPostures(hullAbout());
};

TEST_F(CommonPosturesTest, AreAboutTheMiddleOfTheHull) {
  ASSERT_EQ(poses.size(), 12u);
  for (const ContourPose& pose : poses)
    EXPECT_LT((pose.position - Eigen::Vector3d(1.0, 2.0, 0.8)).norm(), 1e-9);
  EXPECT_TRUE(defaultPostures(VisualHull{}).empty());
}

TEST_F(CommonPosturesTest, FaceFourWays) {
  for (size_t direction = 0; direction < 4; ++direction)
    for (size_t posture = 0; posture < 3; ++posture) {
      const Eigen::Vector3d forward =
          poses[3 * direction + posture].rotations[SphericalJoint::kRoot].col(0);
      const double turn = M_PI / 2 * double(direction);
      const Eigen::Vector3d level(std::cos(turn), std::sin(turn), 0);
      EXPECT_NEAR(forward.head<2>().normalized().dot(level.head<2>()), 1.0, 1e-9) << direction;
    }
}

TEST_F(CommonPosturesTest, StandBendAndCrouch) {
  const Eigen::Matrix3Xd upright = points(0), bent = points(1), crouching = points(2);
  const auto rises = [](const Eigen::Matrix3Xd& of, Eigen::Index point) -> Eigen::Vector3d {
    return of.col(point) - of.col(kPelvis);
  };
  EXPECT_GT(rises(upright, kHead).z(), 0.5);
  EXPECT_LT(rises(upright, kLeftAnkle).z(), -0.7);
  EXPECT_GT(rises(bent, kHead).x(), 0.45) << "the head is before the hips";
  EXPECT_LT(rises(bent, kLeftWrist).z(), -0.1) << "arms hang";
  EXPECT_LT(rises(bent, kLeftAnkle).z(), -0.7) << "legs are straight";
  EXPECT_GT(rises(crouching, kLeftKnee).x(), 0.3) << "knees are before the hips";
  EXPECT_GT(rises(crouching, kLeftAnkle).z(), -0.6) << "which are low";
  EXPECT_LT(std::abs(rises(crouching, kLeftAnkle).x()), 0.25) << "over the feet";
}

}  // namespace
}  // namespace markerless_mocap
