#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "body/body_fixture.h"
#include "contour/drawn_body.h"
#include "markerless_mocap/products/body_pose.h"
#include "markerless_mocap/products/pose_tree.h"

namespace markerless_mocap {

/// Someone smaller than believed.
inline ShapeParameters truth() {
  ShapeParameters shape = ShapeStatistics::handMade().meanShape(1.66);
  shape[BodyLength::kThigh] *= 1.04;
  return shape;
}

/// Walks in a circle with swinging arms.
inline ContourPose at(int frame) {
  ContourPose pose = stride();
  const double turn = 0.08 * frame;
  pose.position += 0.35 * Eigen::Vector3d(std::cos(turn), std::sin(turn), 0);
  pose.rotations[SphericalJoint::kRoot] = expSO3({0, 0, turn + M_PI / 2});
  for (const size_t shoulder : {SphericalJoint::kLeftShoulder, SphericalJoint::kRightShoulder})
    pose.rotations[shoulder] =
        expSO3({0, 0.4 * std::sin(0.2 * frame), 0}) * pose.rotations[shoulder];
  pose.angles[RevoluteJoint::kLeftKnee] -= 0.3 * std::sin(0.15 * frame);
  return pose;
}

/// Drawn once for all tests: drawing takes longer than fitting.
inline const std::vector<cv::Mat>& masksAt(int frame) {
  static std::map<int, std::vector<cv::Mat>> drawn;
  std::vector<cv::Mat>& masks = drawn[frame];
  if (masks.empty()) masks = drawnMasks(drawnRig(5), ContourBody(truth()), at(frame));
  return masks;
}

/// What a tree of the pose tells: `mirrored` takes left for right.
inline PoseTree treeOf(const ContourBody& body, const ContourPose& pose, bool mirrored) {
  // Of contourPointNames(), left ones first.
  constexpr int kPoints[kTreeJointCount] = {1, 3, 6, 4, 7, 5, 8, 9, 12, 10, 13, 11, 14};
  const Eigen::Matrix3Xd points = body.points(pose);
  PoseTree tree;
  tree.status = TreeStatus::kOk;
  tree.joints[0] = points.col(1);
  for (size_t joint = 1; joint < kTreeJointCount; ++joint) {
    const size_t other = joint % 2 ? joint + 1 : joint - 1;
    tree.joints[joint] = points.col(kPoints[mirrored ? other : joint]);
  }
  return tree;
}

/// Mean distance of the fifteen joints of a URDF body from the drawn ones, metres.
inline double errorOf(const BodyModel& model, const BodyPose& pose, int frame) {
  LinkPoses T_world_link;
  model.forwardKinematics(pose.T_world_body, pose.angles, T_world_link);
  const auto markers = markerPositions(model, T_world_link);
  const Eigen::Matrix3Xd points = ContourBody(truth()).points(at(frame));
  double sum = 0;
  for (size_t i = 0; i < markers.size(); ++i)
    sum += (markers[i] - points.col(Eigen::Index(i))).norm() / double(markers.size());
  return sum;
}

}  // namespace markerless_mocap
