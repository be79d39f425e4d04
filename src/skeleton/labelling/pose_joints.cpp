#include "skeleton/labelling/pose_joints.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace markerless_mocap {
namespace {

// Fractions of the longest path, means over people of the virtual studio, as `scripts/fit_pose_tree
// shares` measures them. It gives shoulders and hips beside the nearest point of the trunk's path;
// here that point is up to 0.03 away along it, and "up" makes up for it.
constexpr double kWrist = 0.038, kElbow = 0.1445;            // from the knuckles
constexpr double kAnkle = 0.054, kKnee = 0.229;              // from the ball of the foot
constexpr double kNeckDown = 0.07;                           // from the head's extremity
constexpr double kShouldersDown = 0.13, kHipsDown = 0.31;    // from the head's extremity
constexpr double kShoulderOut = 0.069, kShoulderUp = 0.027;  // from the trunk's path
constexpr double kHipOut = 0.0365, kHipUp = -0.0215;

/// Path length from a path's end to its point nearest to `position`, metres.
double pathLengthTo(const NodePath& path, const Eigen::Vector3d& position) {
  double nearest = (path.front() - position).squaredNorm(), path_length = 0.0, best = 0.0;
  for (size_t i = 1; i < path.size(); ++i) {
    path_length += (path[i] - path[i - 1]).norm();
    const double distance = (path[i] - position).squaredNorm();
    if (distance >= nearest) continue;
    nearest = distance;
    best = path_length;
  }
  return best;
}

std::optional<Eigen::Vector3d> atPathLength(const NodePath& path, double path_length) {
  for (size_t i = 1; i < path.size(); ++i) {
    const double step = (path[i] - path[i - 1]).norm();
    if (step > 0.0 && step >= path_length)
      return path[i - 1] + path_length / step * (path[i] - path[i - 1]);
    path_length -= step;
  }
  return std::nullopt;
}

double ownLength(const PoseTree& tree, int32_t node) {
  const TreePart part = tree.nodes[size_t(node)].part;
  double length = 0.0;
  for (int32_t up = tree.nodes[size_t(node)].parent; up >= 0 && tree.nodes[size_t(up)].part == part;
       node = up, up = tree.nodes[size_t(node)].parent)
    length += (tree.nodes[size_t(up)].position - tree.nodes[size_t(node)].position).norm();
  return length;
}

void placeOn(const TreeExtremity& extremity, double fraction, TreeJoint joint,
             double max_path_length, PoseTree* tree) {
  const NodePath path = pathUp(*tree, extremity.node);
  const double path_length = pathLengthTo(path, extremity.position) + fraction;
  if (path_length <= max_path_length) tree->joints[size_t(joint)] = atPathLength(path, path_length);
}

}  // namespace

void placeJoints(const BodyAxes& axes, double longest, PoseTree* tree) {
  constexpr TreeJoint kJoints[2][6] = {
      {TreeJoint::kLeftWrist, TreeJoint::kLeftElbow, TreeJoint::kLeftAnkle, TreeJoint::kLeftKnee,
       TreeJoint::kLeftShoulder, TreeJoint::kLeftHip},
      {TreeJoint::kRightWrist, TreeJoint::kRightElbow, TreeJoint::kRightAnkle,
       TreeJoint::kRightKnee, TreeJoint::kRightShoulder, TreeJoint::kRightHip}};
  const TreeExtremity& a_foot = tree->extremity(Extremity::kLeftFoot);
  NodePath trunk = pathUp(*tree, a_foot.node);
  std::reverse(trunk.begin(), trunk.end());
  tree->joints[size_t(TreeJoint::kNeck)] = atPathLength(trunk, kNeckDown * longest);
  const auto shoulders = atPathLength(trunk, kShouldersDown * longest);
  const auto hips = atPathLength(trunk, kHipsDown * longest);
  const Eigen::Vector3d up = axes.forward.cross(axes.left);
  for (int side = 0; side < 2; ++side) {
    const TreeJoint* joints = kJoints[side];
    const Eigen::Vector3d out = side == 0 ? axes.left : Eigen::Vector3d(-axes.left);
    const TreeExtremity& hand = tree->extremities[size_t(Extremity::kLeftHand) + size_t(side)];
    const TreeExtremity& foot = tree->extremities[size_t(Extremity::kLeftFoot) + size_t(side)];
    const double arm = ownLength(*tree, hand.node);
    placeOn(hand, kWrist * longest, joints[0], arm, tree);
    placeOn(hand, kElbow * longest, joints[1], arm, tree);
    placeOn(foot, kAnkle * longest, joints[2], longest, tree);
    placeOn(foot, kKnee * longest, joints[3], longest, tree);
    if (shoulders)
      tree->joints[size_t(joints[4])] =
          *shoulders + longest * (kShoulderOut * out + kShoulderUp * up);
    if (hips) tree->joints[size_t(joints[5])] = *hips + longest * (kHipOut * out + kHipUp * up);
  }
}

}  // namespace markerless_mocap
