#include "capture/truth/body_retargeter.h"

#include <gtest/gtest.h>

#include <cmath>

#include "capture/ground_truth.h"
#include "capture/studio_fixture.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

class DrivenBodyTest : public ::testing::Test {
 protected:
  DrivenBodyTest() { model_ = std::make_shared<BodyModel>(human(proportionsOf(skeleton_))); }

  /// Stands with arms hanging and turns bones, each against its parent, on top of that.
  HumanPose posed(const std::vector<std::pair<Bone, Quaterniond>>& turns) const {
    PerBone<Quaterniond> local;
    local.fill(Quaterniond::Identity());
    local[size_t(Bone::kLeftUpperArm)] = AngleAxisd(-1.35, Vector3d::UnitX());
    local[size_t(Bone::kRightUpperArm)] = AngleAxisd(1.35, Vector3d::UnitX());
    for (const auto& [bone, turn] : turns) local[size_t(bone)] = turn * local[size_t(bone)];
    HumanPose pose;
    pose.hips = Vector3d(0.3, -0.2, 0.9);
    pose[Bone::kHips] = local[0];
    for (int i = 1; i < kBoneCount; ++i) pose[Bone(i)] = pose[parentOf(Bone(i))] * local[size_t(i)];
    return pose;
  }
  /// Mean distance between the fifteen joints of the retargeted body and those of the person,
  /// metres.
  double distance(const BodyState& state, const HumanPose& pose) const {
    LinkPoses T_world_link;
    model_->forwardKinematics(state.T_world_body, state.angles, T_world_link);
    const std::vector<Vector3d> driven = markerPositions(*model_, T_world_link);
    const std::vector<Vector3d> points = groundTruthPoints(skeleton_, pose);
    double sum = 0.0;
    for (size_t i = 0; i < driven.size(); ++i) sum += (driven[i] - points[i]).norm();
    return sum / double(driven.size());
  }
  double angle(const BodyState& state, const char* joint) const {
    return state.angles[model_->angleIndex(joint)];
  }

  const HumanSkeleton skeleton_ = HumanSkeleton::adult(1.78, 0.8);
  std::shared_ptr<const BodyModel> model_;
};

Quaterniond about(double angle, double x, double y, double z) {
  return Quaterniond(AngleAxisd(angle, Vector3d(x, y, z).normalized()));
}

TEST_F(DrivenBodyTest, standsWhereThePersonStands) {
  const HumanPose pose = posed({{Bone::kHips, about(0.7, 0, 0, 1)}});
  const BodyState state = BodyRetargeter(model_, skeleton_).follow(pose);
  EXPECT_LT(distance(state, pose), 0.010);
  EXPECT_NEAR(angle(state, "l_knee"), 0.0, 0.06);
  EXPECT_NEAR(angle(state, "waist"), 0.0, 0.06);
}

TEST_F(DrivenBodyTest, hingesBendByTheirOwnAngles) {
  const HumanPose pose = posed({{Bone::kLeftForearm, about(-1.1, 0, 0, 1)},
                                {Bone::kRightShank, about(0.9, 0, 1, 0)},
                                {Bone::kRightThigh, about(-0.6, 0, 1, 0)}});
  const BodyState state = BodyRetargeter(model_, skeleton_).follow(pose);
  EXPECT_NEAR(angle(state, "l_elbow"), 1.1, 0.05);
  EXPECT_NEAR(angle(state, "r_knee"), -0.9, 0.07);
  EXPECT_NEAR(angle(state, "r_r_hip"), 0.6, 0.07);
  EXPECT_LT(distance(state, pose), 0.010);
}

TEST_F(DrivenBodyTest, feetStayFlatUnderLeaningShanks) {
  const HumanPose pose = posed({{Bone::kLeftThigh, about(-0.7, 0, 1, 0)},
                                {Bone::kLeftShank, about(1.0, 0, 1, 0)},
                                {Bone::kLeftFoot, about(-0.3, 0, 1, 0)},
                                {Bone::kRightFoot, about(0.4, 0, 1, 0)}});
  const BodyState state = BodyRetargeter(model_, skeleton_).follow(pose);
  EXPECT_NEAR(angle(state, "l_ankle"), 0.3, 0.05);
  EXPECT_NEAR(angle(state, "r_ankle"), -0.4, 0.05);
  LinkPoses links;
  model_->forwardKinematics(state.T_world_body, state.angles, links);
  const Vector3d forward = links[size_t(model_->linkIndex("l_ankle"))].linear().col(0);
  EXPECT_NEAR(forward.z(), 0.0, 0.02);
}

TEST_F(DrivenBodyTest, jointsStayNearThePersonsInManyPoses) {
  BodyRetargeter body(model_, skeleton_);
  double sum = 0.0;
  for (int i = 0; i < 200; ++i) {
    const auto wave = [i](double rate, double size) { return size * std::sin(rate * 0.1 * i); };
    const HumanPose pose = posed({{Bone::kHips, about(0.05 * i, 0, 0, 1)},
                                  {Bone::kSpine, about(0.15 + wave(1.0, 0.25), 0, 1, 0)},
                                  {Bone::kChest, about(wave(1.7, 0.15), 1, 0, 1)},
                                  {Bone::kHead, about(wave(1.3, 0.6), 0.1, 0.3, 1)},
                                  {Bone::kLeftUpperArm, about(0.8 + wave(1.9, 1.1), 1, 0.3, 0)},
                                  {Bone::kRightUpperArm, about(-0.9 + wave(2.3, 0.9), 1, 0, 0.4)},
                                  {Bone::kLeftForearm, about(-0.8 + wave(2.1, 0.7), 0, 0, 1)},
                                  {Bone::kRightForearm, about(0.9 + wave(1.1, 0.8), 0, 0, 1)},
                                  {Bone::kLeftThigh, about(-0.5 + wave(1.5, 0.8), 0, 1, 0.1)},
                                  {Bone::kRightThigh, about(-0.4 + wave(1.2, 0.7), 0.2, 1, 0)},
                                  {Bone::kLeftShank, about(1.0 + wave(2.7, 0.9), 0, 1, 0)}});
    const double apart = distance(body.follow(pose), pose);
    EXPECT_LT(apart, 0.025) << i;
    sum += apart;
  }
  EXPECT_LT(sum / 200, 0.015);
}

TEST_F(DrivenBodyTest, anglesMoveSmoothlyAndStayWithinTheLimits) {
  BodyRetargeter body(model_, skeleton_);
  Eigen::VectorXd last;
  for (int i = 0; i < 300; ++i) {
    const double swing = std::sin(0.05 * i);
    const HumanPose pose =
        posed({{Bone::kLeftUpperArm, about(0.35, 1, 0, 0) * about(0.5 * swing, 0, 1, 0)},
               {Bone::kRightUpperArm, about(-1.2 - 0.6 * swing, 1, 0, 0)},
               {Bone::kLeftThigh, about(0.4 * swing, 0, 1, 0)},
               {Bone::kHead, about(0.5 * swing, 0, 0, 1)}});
    const BodyState state = body.follow(pose);
    const double fastest = i == 0 ? 0.0 : (state.angles - last).cwiseAbs().maxCoeff();
    EXPECT_LT(fastest, 0.2) << i;
    last = state.angles;
    for (const BodyJoint& joint : model_->joints()) {
      if (joint.angle_index < 0) continue;
      EXPECT_GE(last[joint.angle_index], joint.lower) << joint.name;
      EXPECT_LE(last[joint.angle_index], joint.upper) << joint.name;
    }
  }
}

}  // namespace
}  // namespace markerless_mocap
