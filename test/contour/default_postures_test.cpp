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

/// A column of voxels from the floor, below (1, 2).
VisualHull columnOf(int decimetres) {
  VisualHull hull;
  hull.lattice.origin = Eigen::Vector3d(0.95, 1.95, -0.05);
  hull.lattice.pitch = 0.1;
  hull.lattice.size = {1, 1, decimetres + 1};
  hull.voxels.resize(size_t(decimetres) + 1);
  for (uint32_t i = 0; i < hull.voxels.size(); ++i) hull.voxels[i].index = i;
  return hull;
}

/// Two metres of voxels along x, four decimetres high.
VisualHull lyingHull() {
  VisualHull hull;
  hull.lattice.origin = Eigen::Vector3d(0.0, 1.95, -0.05);
  hull.lattice.pitch = 0.1;
  hull.lattice.size = {20, 1, 5};
  hull.voxels.resize(100);
  for (uint32_t i = 0; i < hull.voxels.size(); ++i) hull.voxels[i].index = i;
  return hull;
}

class CommonPosturesTest : public testing::Test {
 protected:
  Eigen::Matrix3Xd points(size_t pose) const { return body.points(poses.at(pose)); }

  ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  std::vector<ContourPose> poses = defaultPostures(hullAbout());
};

TEST_F(CommonPosturesTest, AreAboutTheMiddleOfTheHull) {
  ASSERT_GE(poses.size(), 12u);
  for (size_t i = 0; i < 12; ++i)
    EXPECT_LT((poses[i].position - Eigen::Vector3d(1.0, 2.0, 0.8)).norm(), 1e-9);
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

/// Whether a pose exists whose head is within 0.25 m of `head` and left ankle of `ankle` (from the
/// pelvis: forward along x, up), with the pelvis at a height above the floor.
bool hasPose(const VisualHull& hull, const Eigen::Vector2d& head, const Eigen::Vector2d& ankle,
             double height) {
  const ContourBody body{ShapeStatistics::handMade().meanShape(1.75)};
  for (const ContourPose& pose : defaultPostures(hull)) {
    const Eigen::Matrix3Xd points = body.points(pose);
    const auto of = [&](Eigen::Index point) -> Eigen::Vector2d {
      const Eigen::Vector3d from = points.col(point) - points.col(kPelvis);
      return {from.x(), from.z()};
    };
    if ((of(kHead) - head).norm() < 0.25 && (of(kLeftAnkle) - ankle).norm() < 0.25 &&
        std::abs(pose.position.z() - height) < 0.2)
      return true;
  }
  return false;
}

TEST(LowPosturesTest, AreTriedInHullsOfTheirHeight) {
  const Eigen::Vector2d up(0.0, 0.6), ahead(0.6, 0.05), behind(-0.6, 0.0);
  EXPECT_TRUE(hasPose(columnOf(13), up, {0.45, -0.4}, 0.5)) << "seated";
  EXPECT_TRUE(hasPose(columnOf(12), up, {-0.4, -0.45}, 0.5)) << "kneeling";
  EXPECT_TRUE(hasPose(columnOf(8), ahead, {-0.4, -0.45}, 0.5)) << "crawling";
  EXPECT_TRUE(hasPose(lyingHull(), behind, {0.8, 0.0}, 0.2)) << "lying";
  EXPECT_FALSE(hasPose(columnOf(17), behind, {0.8, 0.0}, 0.85)) << "nobody lies in a high hull";
  EXPECT_FALSE(hasPose(columnOf(4), up, {0.45, -0.4}, 0.5)) << "nor sits in a low one";
}

}  // namespace
}  // namespace markerless_mocap
