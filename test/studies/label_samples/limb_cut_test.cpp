#include "studies/label_samples/limb_cut.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "capture/ground_truth.h"
#include "skeleton/tree_figure.h"

namespace markerless_mocap {
namespace {

/// The points of a figure in its standing pose; what is not needed lies in the trunk.
std::vector<Eigen::Vector3d> pointsOf(const FigurePose& pose) {
  std::vector<Eigen::Vector3d> points(groundTruthNames().size(), {0, 0, 1.2});
  const auto set = [&](const std::string& name, const Eigen::Vector3d& at) {
    const auto found = std::find(groundTruthNames().begin(), groundTruthNames().end(), name);
    points[size_t(found - groundTruthNames().begin())] = at;
  };
  for (const std::string side : {"l_", "r_"}) {
    const bool left = side == "l_";
    const Eigen::Vector3d& hand = left ? pose.left_hand : pose.right_hand;
    const Eigen::Vector3d& elbow = left ? pose.left_elbow : pose.right_elbow;
    const Eigen::Vector3d& ankle = left ? pose.left_ankle : pose.right_ankle;
    set(side + "elbow", elbow);
    set(side + "wrist", elbow + 0.7 * (hand - elbow));
    set(side + "hand_tip", hand);
    set(side + "knee", left ? pose.left_knee : pose.right_knee);
    set(side + "ankle", ankle);
    set(side + "foot_tip", ankle + Eigen::Vector3d(0.17, 0, -0.05));
  }
  set("thorax", {0, 0, 1.45});
  set("head", {0.02, 0, 1.6});
  set("head_top", {0.02, 0, 1.73});
  return points;
}

TEST(LimbCut, OneLimbIsGoneFromSomewhereOnAndTheRestHangsTogether) {
  const FigurePose pose;
  const VisualHull whole = personHull(pose, 0.02);
  const std::vector<Eigen::Vector3d> points = pointsOf(pose);
  const Eigen::Vector3d ends[] = {
      pose.left_hand, pose.right_hand, pose.left_ankle + Eigen::Vector3d(0.17, 0, -0.05),
      pose.right_ankle + Eigen::Vector3d(0.17, 0, -0.05), Eigen::Vector3d(0.02, 0, 1.7)};
  std::mt19937 random(1);
  int arms = 0;
  for (int round = 0; round < 40; ++round) {
    const VisualHull cut = withLimbCut(whole, groundTruthNames(), points, &random);
    EXPECT_LT(cut.voxels.size(), whole.voxels.size());
    EXPECT_GT(cut.voxels.size(), 0.8 * double(whole.voxels.size()));
    int missing = 0;
    for (size_t end = 0; end < 5; ++end) {
      const bool there = std::any_of(cut.voxels.begin(), cut.voxels.end(), [&](const HullVoxel& v) {
        return (cut.lattice.center(v.index) - ends[end]).norm() < 0.04;
      });
      missing += !there;
      arms += !there && end < 2;
    }
    EXPECT_EQ(missing, 1);
  }
  EXPECT_GT(arms, 20);
  EXPECT_LT(arms, 36);
}

}  // namespace
}  // namespace markerless_mocap
