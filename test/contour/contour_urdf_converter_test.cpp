#include "contour/contour_urdf_converter.h"

#include <gtest/gtest.h>

#include "body/body_fixture.h"
#include "contour/drawn_body.h"

namespace markerless_mocap {
namespace {

class ContourConversionTest : public ::testing::Test {
 protected:
  ContourConversionTest() : shape(ShapeStatistics::handMade().meanShape(1.75)), body(shape) {
    model = std::make_shared<BodyModel>(human(proportionsOf(shape)));
  }
  /// Greatest distance between the URDF's joints and the contour body's, metres.
  double farthest(ContourUrdfConverter& conversion, const ContourPose& pose) {
    Eigen::Isometry3d T_world_body;
    conversion.convert(pose, T_world_body, angles);
    LinkPoses T_world_link;
    model->forwardKinematics(T_world_body, angles, T_world_link);
    const auto markers = markerPositions(*model, T_world_link);
    const Eigen::Matrix3Xd points = body.points(pose);
    double most = 0;
    for (size_t i = 0; i < markers.size(); ++i)
      most = std::max(most, (markers[i] - points.col(Eigen::Index(i))).norm());
    return most;
  }

  ShapeParameters shape;
  ContourBody body;
  std::shared_ptr<const BodyModel> model;
  Eigen::VectorXd angles;
};

TEST_F(ContourConversionTest, JointsKeepTheirPlaces) {
  ContourUrdfConverter conversion(model);
  for (unsigned seed = 0; seed < 20; ++seed) {
    ContourPose pose = disturbed(stride(), 0.4, 0.3, seed);
    pose.angles[RevoluteJoint::kSpineTwist] = 0;
    EXPECT_LT(farthest(conversion, pose), 0.002) << seed;
    // The twist moves the clavicles' roots, so their lengths no longer fit exactly.
    pose.angles[RevoluteJoint::kSpineTwist] = 0.3;
    EXPECT_LT(farthest(conversion, pose), 0.009) << seed;
  }
}

TEST_F(ContourConversionTest, ComesBackFromTheUrdf) {
  ContourUrdfConverter conversion(model);
  for (unsigned seed = 0; seed < 20; ++seed) {
    ContourPose pose = disturbed(stride(), 0.4, 0.3, seed);
    pose.angles[RevoluteJoint::kSpineTwist] = 0;
    Eigen::Isometry3d T_world_body;
    conversion.convert(pose, T_world_body, angles);
    EXPECT_LT(boxMinus(pose, conversion.poseOf(T_world_body, angles)).norm(), 1e-9) << seed;
  }
}

TEST_F(ContourConversionTest, AnglesAreContinuousInTime) {
  ContourUrdfConverter conversion(model);
  Eigen::VectorXd last;
  // The left arm swings around in full circles at the side.
  for (int i = 0; i <= 200; ++i) {
    ContourPose pose = stride();
    pose.rotations[SphericalJoint::kLeftShoulder] = expSO3({0, -0.05 * i, 0}) * expSO3({0.5, 0, 0});
    farthest(conversion, pose);
    for (Eigen::Index a = 0; i > 0 && a < angles.size(); ++a)
      EXPECT_LT(std::abs(std::remainder(angles[a] - last[a], 2 * M_PI)), 0.15) << i;
    last = angles;
  }
}

TEST_F(ContourConversionTest, WantsAsManyAnglesAsTheModelHas) {
  const ContourUrdfConverter conversion(model);
  EXPECT_THROW(conversion.poseOf(Eigen::Isometry3d::Identity(), Eigen::VectorXd::Zero(3)),
               std::invalid_argument);
}

}  // namespace
}  // namespace markerless_mocap
