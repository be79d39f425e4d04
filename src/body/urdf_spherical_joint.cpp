#include "body/urdf_spherical_joint.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "body/davenport_angles.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Angles must not grow without bound if a model turns many times.
double unwind(double angle) {
  return std::abs(angle) < 2 * M_PI ? angle : std::remainder(angle, 2 * M_PI);
}

}  // namespace

UrdfSphericalJoint::UrdfSphericalJoint(const BodyModel& model,
                                       const std::array<std::string, 3>& joints) {
  std::array<const BodyJoint*, 3> chain;
  for (int i = 0; i < 3; ++i) chain[i] = &model.joint(joints[i]);
  std::sort(chain.begin(), chain.end(), [](const BodyJoint* a, const BodyJoint* b) {
    return a->child_link < b->child_link;  // parents have smaller link indices
  });
  lower_ = chain[1]->lower;
  upper_ = chain[1]->upper;
  for (int i = 0; i < 3; ++i) {
    const bool linked = i == 0 || (chain[i]->parent_link == chain[i - 1]->child_link &&
                                   std::abs(chain[i]->axis.dot(chain[i - 1]->axis)) < 1e-9);
    if (!linked || chain[i]->angle_index < 0)
      throw std::invalid_argument("body " + model.id() + ": joint " + chain[i]->name +
                                  " must turn about an axis perpendicular to its parent joint's");
    axes_[i] = chain[i]->axis;
    angle_[i] = chain[i]->angle_index;
  }
}

void UrdfSphericalJoint::set(const Matrix3d& R, const Eigen::VectorXd& last,
                             Eigen::VectorXd& angles) const {
  const Vector3d near(last[angle_[0]], last[angle_[1]], last[angle_[2]]);
  const Vector3d t = davenportAngles(R, axes_, near.unaryExpr(&unwind), lower_, upper_);
  for (int i = 0; i < 3; ++i) angles[angle_[i]] = t[i];
}

Matrix3d UrdfSphericalJoint::rotation(const Eigen::VectorXd& angles) const {
  Matrix3d R = Matrix3d::Identity();
  for (int i = 0; i < 3; ++i)
    R = R * Eigen::AngleAxisd(angles[angle_[i]], axes_[i]).toRotationMatrix();
  return R;
}

}  // namespace markerless_mocap
