#include "motion/skeleton/two_bone_ik.h"

#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

/// Columns: direction, the part of the hinge perpendicular to it, their cross product.
Eigen::Matrix3d hingeFrame(const Eigen::Vector3d& direction, const Eigen::Vector3d& hinge) {
  Eigen::Matrix3d frame;
  frame.col(0) = direction.normalized();
  frame.col(1) = (hinge - hinge.dot(frame.col(0)) * frame.col(0)).normalized();
  frame.col(2) = frame.col(0).cross(frame.col(1));
  return frame;
}

}  // namespace

TwoBoneIkResult solveTwoBoneIk(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
                               double upper, double lower, const Eigen::Vector3d& pole,
                               double max_bend) {
  const Eigen::Vector3d offset = target - root;
  const double nearest =
      std::sqrt(upper * upper + lower * lower + 2.0 * upper * lower * std::cos(max_bend));
  const double distance = std::clamp(offset.norm(), nearest, upper + lower);
  const Eigen::Vector3d along =
      offset.norm() > 1e-9 ? Eigen::Vector3d(offset.normalized()) : pole.unitOrthogonal();
  Eigen::Vector3d aside = pole - pole.dot(along) * along;
  aside = aside.norm() > 1e-9 ? Eigen::Vector3d(aside.normalized()) : along.unitOrthogonal();
  const double foot = (upper * upper - lower * lower + distance * distance) / (2.0 * distance);
  const double height = std::sqrt(std::max(0.0, upper * upper - foot * foot));
  return {root + foot * along + height * aside, root + distance * along};
}

Eigen::Vector3d softIkTarget(const Eigen::Vector3d& root, const Eigen::Vector3d& target,
                             double length) {
  constexpr double kFree = 0.99, kRest = 0.0095;
  const double distance = (target - root).norm() / length;
  if (distance <= kFree) return target;
  const double eased = kFree + kRest * std::tanh((distance - kFree) / kRest);
  return root + (target - root) * (eased / distance);
}

Eigen::Quaterniond turnWithHinge(const Eigen::Vector3d& from, const Eigen::Vector3d& hinge_from,
                                 const Eigen::Vector3d& to, const Eigen::Vector3d& hinge_to) {
  return Eigen::Quaterniond(hingeFrame(to, hinge_to) * hingeFrame(from, hinge_from).transpose());
}

}  // namespace markerless_mocap
