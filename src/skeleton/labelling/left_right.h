#pragma once

#include <Eigen/Core>
#include <vector>

#include "markerless_mocap/products/pose_tree.h"
#include "markerless_mocap/skeleton/pose_tree_options.h"
#include "skeleton/graph/tree_parts.h"

namespace markerless_mocap {

/// Positions of the nodes of a limb or the torso from its end upwards, world metres.
using NodePath = std::vector<Eigen::Vector3d>;

/// The paths from which forward and left are estimated.
struct BodyPaths {
  NodePath torso;  ///< upwards
  NodePath head;
  NodePath arms[2];
  NodePath own_legs[2];  ///< up to where they meet
  NodePath legs[2];      ///< up to the hips, with the section that both share
  double longest = 0.0;  ///< longest path, the unit of the proportions, metres
};
BodyPaths bodyPaths(const RerootedTree& tree, double longest, const PoseTreeOptions& options);

/// Direction of the least-squares line through points, unit length, towards the last point; zero if
/// there are fewer than two points.
Eigen::Vector3d lineDirection(const NodePath& points);

/// The path from a node of a labelled tree to its root.
NodePath pathUp(const PoseTree& tree, int32_t node);

/// The points of a path whose path lengths from its end are between two limits, metres.
NodePath pathSection(const NodePath& path, double from, double to);

/// Axes of a body, unit vectors in the world.
struct BodyAxes {
  bool known = false;
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< along the torso, to the neck
  Eigen::Vector3d forward = Eigen::Vector3d::Zero(), left = Eigen::Vector3d::Zero();
  double agreement = 0.0;  ///< cosine between the forward directions of the two legs
};

/// Forward from the bends of ankles and knees (Algorithm 5).
BodyAxes findAxes(const BodyPaths& body, const PoseTreeOptions& options);

/// Whether limb 1 of a pair is the left one, by the angles of the limbs' sections at the torso
/// (Algorithm 6).
bool firstIsLeftByAngles(const NodePath (&limbs)[2], double fraction, const BodyPaths& body,
                         const BodyAxes& axes);

/// Distance by which the upper half of limb 1 lies further to the left than that of limb 2, metres.
double leftOffset(const NodePath& first, const NodePath& second, const BodyAxes& axes);

}  // namespace markerless_mocap
