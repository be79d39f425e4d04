#include "fleischmann/model/fleischmann_urdf_converter.h"

#include <gtest/gtest.h>

#include <random>

#include "body/body_fixture.h"

namespace markerless_mocap {
namespace {

TEST(FleischmannUrdfConverter, roundTripsAnyPoseWithFeetAtRightAngles) {
  const std::shared_ptr<const BodyModel> body = testBody();
  std::mt19937 random(8);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  for (int trial = 0; trial < 30; ++trial) {
    Eigen::VectorXd angles(body->angleCount());
    for (const BodyJoint& joint : body->joints())
      if (joint.angle_index >= 0)
        angles[joint.angle_index] = joint.lower + share(random) * (joint.upper - joint.lower);
    for (const char* ankle : {"l_ankle", "r_ankle"}) angles[body->angleIndex(ankle)] = 0.0;
    Eigen::Isometry3d root(
        Eigen::AngleAxisd(6.0 * share(random), Eigen::Vector3d(0.1, 0.3, 1).normalized()));
    root.translation() << 1.0, -2.0, 0.9;
    FleischmannUrdfConverter there(body), back(body);
    Eigen::Isometry3d root_again = Eigen::Isometry3d::Identity();
    Eigen::VectorXd angles_again;
    back.convert(there.parametersOf(root, angles), root_again, angles_again);
    LinkPoses expected, links;
    body->forwardKinematics(root, angles, expected);
    body->forwardKinematics(root_again, angles_again, links);
    // A ball's two solutions differ in the links inside it, and in nothing that has a shape.
    for (const RoundCone& cone : body->shape()) {
      const auto i = size_t(cone.link);
      EXPECT_TRUE(links[i].isApprox(expected[i], 1e-6)) << body->links()[i];
    }
  }
}

TEST(FleischmannUrdfConverter, followsASwingWithoutJumps) {
  FleischmannUrdfConverter conversion(testBody());
  Eigen::Isometry3d root = Eigen::Isometry3d::Identity();
  Eigen::VectorXd angles, last;
  FleischmannVector v = FleischmannVector::Zero();
  for (int i = 0; i <= 100; ++i) {
    v[kLeftShoulder] = 0.1;
    v[kLeftShoulder + 1] = 0.02 * (i - 50);
    v[kPelvisOrientation + 2] = 0.1 * i;
    conversion.convert(v, root, angles);
    if (i > 0) {
      EXPECT_LT((angles - last).cwiseAbs().maxCoeff(), 0.35) << i;
    }
    last = angles;
  }
}

}  // namespace
}  // namespace markerless_mocap
