#pragma once

#include <Eigen/Core>
#include <vector>

#include "skeleton/graph/tree_parts.h"

namespace markerless_mocap {

/// A limb's or the torso's nodes, world metres, from the end upwards.
using NodePath = std::vector<Eigen::Vector3d>;

/// What sides are told by.
struct BodyPaths {
  NodePath torso;  ///< upwards
  NodePath head;
  NodePath arms[2];
  NodePath own_legs[2];  ///< up to where they meet
  NodePath legs[2];      ///< up to the hips, also what they share
  double longest = 0.0;  ///< the measure of the proportions, metres
};
BodyPaths bodyPaths(const RerootedTree& tree, double longest);

/// Direction of the line through points that leaves the least squared distances, unit length,
/// towards the last point; zero if there are fewer than two points.
Eigen::Vector3d lineDirection(const NodePath& points);

/// The points of a path between two shares of the longest path from its end.
NodePath stretch(const NodePath& path, double from, double to);

/// Where a body faces.
struct BodyAxes {
  bool known = false;
  Eigen::Vector3d up = Eigen::Vector3d::Zero();  ///< along the torso, to the neck
  Eigen::Vector3d forward = Eigen::Vector3d::Zero(), left = Eigen::Vector3d::Zero();
  double agreement = 0.0;  ///< cosine between what the two legs say
  double bend = 0.0;       ///< length of the sum of the joints' normals that forward comes from
};

/// Forward from the bends of ankles and knees (Algorithm 5).
BodyAxes findAxes(const BodyPaths& body);

/// Whether limb 1 of a pair is the left one, by the angles of what leads to the torso (Algorithm
/// 6).
bool firstIsLeftByAngles(const NodePath (&limbs)[2], double fraction, const BodyPaths& body,
                         const BodyAxes& axes);

/// How much further to the left the upper half of limb 1 lies than that of limb 2, metres.
double leftOffset(const NodePath& first, const NodePath& second, const BodyAxes& axes);

}  // namespace markerless_mocap
