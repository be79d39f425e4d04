#include "hsiao/model/hsiao_body_model.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "hsiao/model/hsiao_urdf_converter.h"
#include "hsiao/synthetic_person.h"
#include "numerics/counter_random.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

class HsiaoProfileTest : public testing::Test {
 protected:
  Vector3d bone(const HsiaoVector& v, PartLabel part, int node) const {
    HsiaoFrames frames;
    body_model_->frames(v.data(), frames);
    return body_model_->bones(part)[node].inWorld(frames);
  }
  HsiaoVector randomVector(int seed) const {
    const HsiaoLimits limits = HsiaoLimits::fromThesis();
    HsiaoVector v;
    const auto uniform = [seed](int i) { return CounterRandom(seed).uniform(i); };
    for (int i = 0; i < 3; ++i) v[i] = 2.0 * uniform(i) - 1.0;
    v.segment<3>(kHsiaoNeck) =
        v.segment<3>(kHsiaoCenter) + Vector3d(uniform(3) - 0.5, uniform(4) - 0.5, 0.6);
    v[kHsiaoSpin] = 6.0 * uniform(6) - 3.0;
    for (int k = 1; k <= kHsiaoAngles; ++k)
      v[hsiaoTheta(k)] =
          limits.lower[k - 1] + uniform(10 + k) * (limits.upper[k - 1] - limits.lower[k - 1]);
    return v;
  }
  std::shared_ptr<const BodyModel> body_ = testBody();
  std::shared_ptr<const HsiaoBodyModel> body_model_ = std::make_shared<HsiaoBodyModel>(*body_);
};

TEST_F(HsiaoProfileTest, AllAnglesZeroIsTheThesisTPose) {
  HsiaoVector v = standing(*body_model_);
  v[hsiaoTheta(3)] = v[hsiaoTheta(4)] = 0.0;
  for (int side = 0; side < 2; ++side) {
    const PartLabel arm = PartLabel(int(PartLabel::kArm1) + side);
    const Vector3d out = Vector3d::UnitY() * (side == 0 ? 1.0 : -1.0);
    for (int node = 0; node < 3; ++node) {
      const Vector3d step = bone(v, arm, node + 1) - bone(v, arm, node);
      EXPECT_LT((step.normalized() - out).norm(), 1e-9) << "side " << side << " bone " << node;
    }
  }
  EXPECT_NEAR((bone(v, PartLabel::kTorso, 1) - v.segment<3>(kHsiaoNeck)).norm(), 0.0, 1e-9);
}

TEST_F(HsiaoProfileTest, AnglesTurnAsInTheThesis) {
  HsiaoVector v = standing(*body_model_);
  v[hsiaoTheta(9)] = -M_PI / 2;  // left elbow: forearm of the hanging arm forward
  v[hsiaoTheta(10)] = M_PI / 2;
  v[hsiaoTheta(16)] = M_PI / 2;   // right knee: shank back
  v[hsiaoTheta(13)] = -M_PI / 2;  // left hip: thigh forward
  const auto along = [&](PartLabel part, int node) -> Vector3d {
    return (bone(v, part, node + 1) - bone(v, part, node)).normalized();
  };
  EXPECT_LT((along(PartLabel::kArm1, 0) + Vector3d::UnitZ()).norm(), 1e-9);
  EXPECT_LT((along(PartLabel::kArm1, 1) - Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((along(PartLabel::kArm2, 1) - Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((along(PartLabel::kLeg2, 1) + Vector3d::UnitX()).norm(), 1e-9);
  EXPECT_LT((along(PartLabel::kLeg1, 0) - Vector3d::UnitX()).norm(), 1e-9);
}

TEST_F(HsiaoProfileTest, SpinTurnsTheBodyAboutItsOwnLeaningAxis) {
  HsiaoVector v = standing(*body_model_);
  v.segment<3>(kHsiaoNeck) += Vector3d(0.2, 0.1, 0.0);
  const Vector3d neck = bone(v, PartLabel::kTorso, 1), shoulder = bone(v, PartLabel::kArm1, 0);
  const Vector3d center = v.segment<3>(kHsiaoCenter), axis = (neck - center).normalized();
  v[kHsiaoSpin] = 0.8;
  EXPECT_LT((bone(v, PartLabel::kTorso, 1) - neck).norm(), 1e-9);
  const Vector3d turned = center + AngleAxisd(0.8, axis) * (shoulder - center);
  EXPECT_LT((bone(v, PartLabel::kArm1, 0) - turned).norm(), 1e-9);
}

TEST_F(HsiaoProfileTest, TheConvertedUrdfPoseHasTheSameJoints) {
  const std::vector<std::pair<PartLabel, std::vector<std::string>>> chains = {
      {PartLabel::kHead, {"r_head"}},
      {PartLabel::kArm1, {"l_shoulder", "l_elbow", "l_wrist"}},
      {PartLabel::kArm2, {"r_shoulder", "r_elbow", "r_wrist"}},
      {PartLabel::kLeg1, {"l_hip", "l_knee", "l_ankle"}},
      {PartLabel::kLeg2, {"r_hip", "r_knee", "r_ankle"}}};
  HsiaoUrdfConverter conversion(body_, body_model_);
  for (int seed = 0; seed < 200; ++seed) {
    const HsiaoVector v = randomVector(seed);
    Eigen::Isometry3d root;
    Eigen::VectorXd angles;
    conversion.convert(v, root, angles);
    LinkPoses links;
    body_->forwardKinematics(root, angles, links);
    for (const auto& [part, names] : chains)
      for (size_t i = 0; i < names.size(); ++i)
        ASSERT_LT((links[body_->linkIndex(names[i])].translation() - bone(v, part, i)).norm(), 1e-6)
            << names[i] << " seed " << seed;
    HsiaoFrames frames;
    body_model_->frames(v.data(), frames);
    ASSERT_LT((links[body_->linkIndex("l_ankle")].linear() - frames.R[kShankSegment]).norm(), 1e-6);
    ASSERT_LT((links[body_->linkIndex("head")].linear() - frames.R[kHeadSegment]).norm(), 1e-6);
  }
}

TEST_F(HsiaoProfileTest, AnArmSwingsThroughHangingWithoutAJump) {
  HsiaoUrdfConverter conversion(body_, body_model_);
  Eigen::VectorXd last;
  for (int step = -60; step <= 60; ++step) {
    HsiaoVector v = standing(*body_model_);
    v[hsiaoTheta(3)] += degrees(0.5 * step);  // sideways, through hanging, across the body
    v[hsiaoTheta(14)] = degrees(0.5 * step);
    Eigen::Isometry3d root;
    Eigen::VectorXd angles;
    conversion.convert(v, root, angles);
    if (last.size() > 0) {
      ASSERT_LT((angles - last).cwiseAbs().maxCoeff(), degrees(1.0)) << "step " << step;
    }
    last = angles;
  }
}

TEST_F(HsiaoProfileTest, ARaisedArmKeepsItsShoulderInsideItsLimits) {
  HsiaoUrdfConverter conversion(body_, body_model_);
  HsiaoVector v = standing(*body_model_);
  v[hsiaoTheta(3)] = v[hsiaoTheta(4)] = 0.0;
  Eigen::Isometry3d root;
  Eigen::VectorXd angles;
  conversion.convert(v, root, angles);
  for (const BodyJoint& joint : body_->joints()) {
    if (joint.angle_index < 0) continue;
    EXPECT_GE(angles[joint.angle_index], joint.lower - 1e-9) << joint.name;
    EXPECT_LE(angles[joint.angle_index], joint.upper + 1e-9) << joint.name;
  }
  EXPECT_NEAR(angles[body_->angleIndex("l_p_shoulder")], M_PI / 2, 1e-6);
  EXPECT_NEAR(angles[body_->angleIndex("r_p_shoulder")], M_PI / 2, 1e-6);
}

}  // namespace
}  // namespace markerless_mocap
