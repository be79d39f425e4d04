#include "capture/ground_truth.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {
namespace {

Eigen::Vector3d point(const std::vector<Eigen::Vector3d>& points, const std::string& name) {
  const auto& names = groundTruthNames();
  return points.at(size_t(std::find(names.begin(), names.end(), name) - names.begin()));
}

TEST(TruthTest, beginsWithTheMarkersOfTheErrorMeasure) {
  const auto& names = groundTruthNames();
  ASSERT_EQ(names.size(), 24u);
  EXPECT_TRUE(std::equal(markerNames().begin(), markerNames().end(), names.begin()));
  EXPECT_EQ(names.back(), "head_top");
}

TEST(TruthTest, pointsOfTheTPoseAreTheSkeletons) {
  const HumanSkeleton s = HumanSkeleton::adult(1.8, 1.0);
  HumanPose pose;
  pose.hips = s.headOf(Bone::kHips);
  const auto points = groundTruthPoints(s, pose);
  const auto expectAt = [&](const char* name, const Eigen::Vector3d& wanted) {
    EXPECT_LT((point(points, name) - wanted).norm(), 1e-12) << name;
  };
  expectAt("pelvis", s.headOf(Bone::kHips));
  expectAt("thorax", s.headOf(Bone::kNeck));
  expectAt("head", 0.5 * (s.headOf(Bone::kHead) + s.tailOf(Bone::kHead)));
  expectAt("l_shoulder", s.headOf(Bone::kLeftUpperArm));
  expectAt("r_elbow", s.headOf(Bone::kRightForearm));
  expectAt("l_wrist", s.headOf(Bone::kLeftHand));
  expectAt("r_hip", s.headOf(Bone::kRightThigh));
  expectAt("l_knee", s.headOf(Bone::kLeftShank));
  expectAt("r_ankle", s.headOf(Bone::kRightFoot));
  expectAt("l_foot", s.headOf(Bone::kLeftToes));
  expectAt("r_foot_tip", s.tailOf(Bone::kRightToes));
  expectAt("r_hand_tip", s.tailOf(Bone::kRightHand));
  expectAt("head_top", s.tailOf(Bone::kHead));
  expectAt("l_hand", s.headOf(Bone::kLeftHand) +
                         0.53 * (s.tailOf(Bone::kLeftHand) - s.headOf(Bone::kLeftHand)));
  EXPECT_GT(point(points, "l_wrist").y(), 0.5);
}

TEST(TruthTest, pointsGoAlongWithTheirBones) {
  const HumanSkeleton s = HumanSkeleton::adult(1.7, 0.0);
  HumanPose pose;
  pose.hips = Eigen::Vector3d(0.5, 0.2, 0.9);
  const Eigen::Quaterniond quarter(
      Eigen::AngleAxisd(M_PI_2, Eigen::Vector3d::UnitZ()));  // left forearm points back
  pose[Bone::kLeftForearm] = pose[Bone::kLeftHand] = quarter;
  const auto points = groundTruthPoints(s, pose);
  const Eigen::Vector3d elbow = point(points, "l_elbow");
  const double reach = s.lengthOf(Bone::kLeftForearm) + s.lengthOf(Bone::kLeftHand);
  EXPECT_LT((point(points, "l_hand_tip") - elbow - Eigen::Vector3d(-reach, 0, 0)).norm(), 1e-3);
}

}  // namespace
}  // namespace markerless_mocap
