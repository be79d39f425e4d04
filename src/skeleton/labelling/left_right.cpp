#include "skeleton/labelling/left_right.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

double angle(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::acos(std::clamp(a.dot(b), -1.0, 1.0));
}

/// Axis of a hinge joint, to the left; zero if the joint is straight.
Eigen::Vector3d hinge(const Eigen::Vector3d& below, const Eigen::Vector3d& above, double min_bend) {
  const Eigen::Vector3d axis = below.cross(above);
  return axis.norm() > min_bend ? axis : Eigen::Vector3d(Eigen::Vector3d::Zero());
}

/// Sum of the axes of a leg's ankle and knee.
Eigen::Vector3d legNormal(const NodePath& leg, bool foot_seen, double longest,
                          const PoseTreeOptions& options) {
  const LimbRatios& ratios = options.limb_ratios;
  const double ankle = (ratios.foot + ratios.toe) * longest,
               knee = ankle + ratios.lower_leg * longest;
  const Eigen::Vector3d foot = lineDirection(pathSection(leg, 0.0, ankle));
  const Eigen::Vector3d shank = lineDirection(pathSection(leg, ankle, knee));
  const Eigen::Vector3d thigh =
      lineDirection(pathSection(leg, knee, knee + ratios.thigh * longest));
  Eigen::Vector3d normal = hinge(shank, -thigh, options.min_bend);
  if (foot_seen) normal += hinge(foot, shank, options.min_bend);
  return normal;
}

double lengthOf(const NodePath& path) {
  double length = 0.0;
  for (size_t i = 1; i < path.size(); ++i) length += (path[i] - path[i - 1]).norm();
  return length;
}

}  // namespace

BodyPaths bodyPaths(const RerootedTree& tree, double longest, const PoseTreeOptions& options) {
  BodyPaths body;
  body.longest = longest;
  body.head = limbPath(tree, UnsidedExtremity::kHead);
  body.arms[0] = limbPath(tree, UnsidedExtremity::kHand1);
  body.arms[1] = limbPath(tree, UnsidedExtremity::kHand2);
  body.own_legs[0] = body.legs[0] = limbPath(tree, UnsidedExtremity::kFoot1);
  body.own_legs[1] = body.legs[1] = limbPath(tree, UnsidedExtremity::kFoot2);
  for (const TreeNode& node : tree.nodes)
    if (node.part == TreePart::kTorso) body.torso.push_back(node.position);
  // If the legs are merged, the torso's path also contains the way to the feet: only the length of
  // a torso is used.
  const NodePath torso =
      pathSection(body.torso, 0.0, options.max_torso * options.limb_ratios.torso() * longest);
  for (size_t i = body.torso.size(); i-- > torso.size();)
    for (NodePath& leg : body.legs) leg.push_back(body.torso[i]);
  body.torso.assign(torso.rbegin(), torso.rend());
  return body;
}

Eigen::Vector3d lineDirection(const NodePath& points) {
  if (points.size() < 2) return Eigen::Vector3d::Zero();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += p;
  mean /= double(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& p : points) spread += (p - mean) * (p - mean).transpose();
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver;
  solver.computeDirect(spread);
  const Eigen::Vector3d line = solver.eigenvectors().col(2);
  return line.dot(points.back() - points.front()) < 0.0 ? Eigen::Vector3d(-line) : line;
}

NodePath pathUp(const PoseTree& tree, int32_t node) {
  NodePath path;
  for (; node >= 0; node = tree.nodes[size_t(node)].parent)
    path.push_back(tree.nodes[size_t(node)].position);
  return path;
}

NodePath pathSection(const NodePath& path, double from, double to) {
  NodePath out;
  double path_length = 0.0;
  for (size_t i = 0; i < path.size(); ++i) {
    if (i > 0) path_length += (path[i] - path[i - 1]).norm();
    if (path_length >= from && path_length <= to) out.push_back(path[i]);
  }
  return out;
}

BodyAxes findAxes(const BodyPaths& body, const PoseTreeOptions& options) {
  BodyAxes axes;
  axes.up = lineDirection(body.torso);
  const double foot = (options.limb_ratios.foot + options.limb_ratios.toe) * body.longest;
  const double first = lengthOf(body.legs[0]), second = lengthOf(body.legs[1]);
  Eigen::Vector3d forward = Eigen::Vector3d::Zero();
  Eigen::Vector3d legs[2] = {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  for (int leg = 0; leg < 2; ++leg) {
    const bool foot_seen = (leg == 0 ? second - first : first - second) < options.short_leg * foot;
    const Eigen::Vector3d normal = legNormal(body.legs[leg], foot_seen, body.longest, options);
    if (normal.norm() > 0.0) legs[leg] = normal.normalized().cross(axes.up);
    forward += legs[leg];
  }
  axes.known = forward.norm() > 1e-6 && axes.up.norm() > 0.5;
  if (!axes.known) return axes;
  axes.agreement = legs[0].stableNormalized().dot(legs[1].stableNormalized());
  axes.forward = forward.normalized();
  axes.left = axes.up.cross(axes.forward).normalized();
  return axes;
}

bool firstIsLeftByAngles(const NodePath (&limbs)[2], double fraction, const BodyPaths& body,
                         const BodyAxes& axes) {
  Eigen::Vector3d away[2];
  for (int i = 0; i < 2; ++i) {
    NodePath path(limbs[i].rbegin(), limbs[i].rend());
    away[i] = lineDirection(pathSection(path, 0.0, fraction * body.longest));
  }
  const double left[2] = {axes.left.dot(away[0]), axes.left.dot(away[1])};
  const bool wider = angle(axes.forward, away[0]) > angle(axes.forward, away[1]);
  if (left[0] > 0.0 && left[1] > 0.0) return wider;
  if (left[0] < 0.0 && left[1] < 0.0) return !wider;
  return left[0] > left[1];
}

double leftOffset(const NodePath& first, const NodePath& second, const BodyAxes& axes) {
  const auto upper = [&](const NodePath& path) {
    double sum = 0.0;
    for (size_t i = path.size() / 2; i < path.size(); ++i) sum += axes.left.dot(path[i]);
    return sum / double(std::max<size_t>(1, path.size() - path.size() / 2));
  };
  return upper(first) - upper(second);
}

}  // namespace markerless_mocap
