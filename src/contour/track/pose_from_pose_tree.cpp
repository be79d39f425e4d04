#include "contour/track/pose_from_pose_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

using A = RevoluteJoint;
using B = SphericalJoint;

// A straighter limb does not determine the plane in which it bends.
constexpr double kStraight = 0.06;  // sine of the bend

/// The three joints of a limb and the degrees of freedom that they determine. `sense`: 1 bends
/// forward, -1 backward.
struct LimbJoints {
  TreeJoint root, middle, end;
  double sense;
  size_t joint, hinge;
};
constexpr LimbJoints kLimbs[] = {{TreeJoint::kLeftShoulder, TreeJoint::kLeftElbow,
                                  TreeJoint::kLeftWrist, 1.0, B::kLeftShoulder, A::kLeftElbow},
                                 {TreeJoint::kRightShoulder, TreeJoint::kRightElbow,
                                  TreeJoint::kRightWrist, 1.0, B::kRightShoulder, A::kRightElbow},
                                 {TreeJoint::kLeftHip, TreeJoint::kLeftKnee, TreeJoint::kLeftAnkle,
                                  -1.0, B::kLeftHip, A::kLeftKnee},
                                 {TreeJoint::kRightHip, TreeJoint::kRightKnee,
                                  TreeJoint::kRightAnkle, -1.0, B::kRightHip, A::kRightKnee}};

/// Coincident or collinear joints span no frame.
bool isRotation(const Eigen::Matrix3d& R) {
  return std::abs(R.determinant() - 1.0) < 1e-6;  // false for NaN
}

/// Aligns the upper bone with root and middle, and its front with the direction of the bend.
void layLimb(const LimbJoints& limb, const PoseTree& tree, ContourPose& pose) {
  const auto &root = tree.joint(limb.root), &middle = tree.joint(limb.middle),
             &end = tree.joint(limb.end);
  if (!root || !middle || !end) return;
  const Eigen::Matrix3d& trunk = pose.rotations[B::kRoot];
  const Eigen::Vector3d along = (*middle - *root).normalized();
  const Eigen::Vector3d beyond = (*end - *middle).normalized();
  const Eigen::Vector3d aside = beyond - along * along.dot(beyond);
  Eigen::Vector3d front =
      limb.sense * aside + std::max(0.0, kStraight - aside.norm()) * trunk.col(0);
  front = (front - along * along.dot(front)).normalized();
  Eigen::Matrix3d upper;
  upper << front, front.cross(along), -along;
  if (!isRotation(upper)) return;
  pose.rotations[limb.joint] = trunk.transpose() * upper;
  pose.angles[limb.hinge] = limb.sense * std::atan2(aside.norm(), along.dot(beyond));
}

}  // namespace

std::optional<ContourPose> poseFromPoseTree(const PoseTree& tree) {
  const auto &left = tree.joint(TreeJoint::kLeftHip), &right = tree.joint(TreeJoint::kRightHip),
             &neck = tree.joint(TreeJoint::kNeck);
  if (!left || !right || !neck) return std::nullopt;
  ContourPose pose;
  pose.position = 0.5 * (*left + *right);
  const Eigen::Vector3d y = (*left - *right).normalized();
  const Eigen::Vector3d x = y.cross(*neck - pose.position).normalized();
  pose.rotations[B::kRoot] << x, y, x.cross(y);
  if (!isRotation(pose.rotations[B::kRoot])) return std::nullopt;
  for (const LimbJoints& limb : kLimbs) layLimb(limb, tree, pose);
  return pose;
}

}  // namespace markerless_mocap
