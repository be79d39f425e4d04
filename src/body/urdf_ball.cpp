#include "body/urdf_ball.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this sine of the middle angle the outer angles are told apart by the last output alone.
constexpr double kSingularSine = 1e-6;

// More than any two solutions lie apart (rad^2).
constexpr double kOutsideCost = 1e3;

// Angle that turns `from` to `to` about `axis`.
double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  const Vector3d f = from - axis * axis.dot(from), t = to - axis * axis.dot(to);
  return std::atan2(axis.dot(f.cross(t)), f.dot(t));
}

double nearestTurn(double angle, double near) {
  return angle + 2 * M_PI * std::round((near - angle) / (2 * M_PI));
}

Vector3d solveOuter(const Matrix3d& R, const std::array<Vector3d, 3>& axes, double middle,
                    double sine, double held_first) {
  const Matrix3d M = AngleAxisd(middle, axes[1]).toRotationMatrix();
  Vector3d t(held_first, middle, 0.0);
  if (std::abs(sine) > kSingularSine) t[0] = angleAbout(axes[0], M * axes[2], R * axes[2]);
  const Matrix3d last = M.transpose() * AngleAxisd(-t[0], axes[0]).toRotationMatrix() * R;
  t[2] = angleAbout(axes[2], axes[1], last * axes[1]);
  return t;
}

// A model turned many times over must not wind up its angles without bound.
double unwind(double angle) {
  return std::abs(angle) < 2 * M_PI ? angle : std::remainder(angle, 2 * M_PI);
}

}  // namespace

Vector3d decomposeRotation(const Matrix3d& R, const std::array<Vector3d, 3>& axes,
                           const Vector3d& near, double middle_lower, double middle_upper) {
  const double shift = std::atan2(axes[0].dot(axes[1].cross(axes[2])), axes[0].dot(axes[2]));
  const Vector3d reached = R * axes[2];
  const double opening = std::atan2(axes[0].cross(reached).norm(), axes[0].dot(reached));
  Vector3d best = Vector3d::Zero();
  double best_distance = HUGE_VAL;
  for (const double sign : {1.0, -1.0}) {
    Vector3d t = solveOuter(R, axes, shift + sign * opening, std::sin(opening), near[0]);
    for (int i = 0; i < 3; ++i) t[i] = nearestTurn(t[i], near[i]);
    const bool inside = t[1] >= middle_lower - 1e-9 && t[1] <= middle_upper + 1e-9;
    const double distance = (t - near).squaredNorm() + (inside ? 0.0 : kOutsideCost);
    if (distance < best_distance) {
      best_distance = distance;
      best = t;
    }
  }
  return best;
}

UrdfBall::UrdfBall(const BodyModel& model, const std::array<std::string, 3>& joints) {
  std::array<const BodyJoint*, 3> chain;
  for (int i = 0; i < 3; ++i) chain[i] = &model.joint(joints[i]);
  std::sort(chain.begin(), chain.end(), [](const BodyJoint* a, const BodyJoint* b) {
    return a->child_link < b->child_link;  // parents come first
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

void UrdfBall::set(const Matrix3d& R, const Eigen::VectorXd& last, Eigen::VectorXd& angles) const {
  const Vector3d near(last[angle_[0]], last[angle_[1]], last[angle_[2]]);
  const Vector3d t = decomposeRotation(R, axes_, near.unaryExpr(&unwind), lower_, upper_);
  for (int i = 0; i < 3; ++i) angles[angle_[i]] = t[i];
}

}  // namespace markerless_mocap
