#include "contour/model/contour_pose.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Matrix3d expSO3(const Vector3d& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

Vector3d logSO3(const Matrix3d& R) {
  Eigen::Quaterniond q(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  if (sine < 1e-12) return 2.0 * q.vec();
  return q.vec() * (2.0 * std::atan2(sine, q.w()) / sine);
}

bool ContourPose::isFinite() const {
  return position.allFinite() &&
         std::all_of(rotations.begin(), rotations.end(),
                     [](const auto& R) { return R.allFinite(); }) &&
         std::all_of(angles.begin(), angles.end(), [](double a) { return std::isfinite(a); });
}

ContourPose boxPlus(const ContourPose& pose, const PoseIncrement& step) {
  ContourPose to = pose;
  to.position += step.head<3>();
  for (int b = 0; b < SphericalJoint::kCount; ++b) {
    const Matrix3d turned = pose.rotations[size_t(b)] * expSO3(step.segment<3>(sphericalDof(b)));
    to.rotations[size_t(b)] = Eigen::Quaterniond(turned).normalized().toRotationMatrix();
  }
  for (int a = 0; a < RevoluteJoint::kCount; ++a) to.angles[size_t(a)] += step[revoluteDof(a)];
  return to;
}

PoseIncrement boxMinus(const ContourPose& to, const ContourPose& from) {
  PoseIncrement step;
  step.head<3>() = to.position - from.position;
  for (size_t b = 0; b < SphericalJoint::kCount; ++b)
    step.segment<3>(sphericalDof(int(b))) = logSO3(from.rotations[b].transpose() * to.rotations[b]);
  for (size_t a = 0; a < RevoluteJoint::kCount; ++a)
    step[revoluteDof(int(a))] = to.angles[a] - from.angles[a];
  return step;
}

}  // namespace markerless_mocap
