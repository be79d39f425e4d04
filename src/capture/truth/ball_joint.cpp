#include "capture/truth/ball_joint.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

double turnsApart(double a, double b) {
  return std::remainder(a - b, 2.0 * kPi);
}

}  // namespace

Vector3d ballAngles(const Matrix3d& R, const JointAxes& axes, const Vector3d& near,
                    double middle_lower, double middle_upper) {
  constexpr double kSingularSine = 1e-6;
  constexpr double kOutside = 1e3;  // more than any two solutions lie apart
  const Vector3d reached = R * axes[2];
  const double aligned =
      std::atan2(axes[0].dot(axes[1].cross(axes[2])), axes[0].dot(axes[2]));  // axes 0, 2 as one
  const double opening = std::acos(std::clamp(axes[0].dot(reached), -1.0, 1.0));
  Vector3d best = near;
  double best_cost = HUGE_VAL;
  for (const double sign : {1.0, -1.0}) {
    Vector3d t(near[0], std::remainder(aligned + sign * opening, 2.0 * kPi), 0.0);
    const Matrix3d middle = AngleAxisd(t[1], axes[1]).toRotationMatrix();
    if (std::sin(opening) > kSingularSine) t[0] = angleAbout(axes[0], middle * axes[2], reached);
    const Matrix3d last = (AngleAxisd(t[0], axes[0]).toRotationMatrix() * middle).transpose() * R;
    t[2] = angleAbout(axes[2], axes[1], last * axes[1]);
    double cost = t[1] < middle_lower - 1e-9 || t[1] > middle_upper + 1e-9 ? kOutside : 0.0;
    for (int i = 0; i < 3; ++i) cost += std::pow(turnsApart(t[i], near[i]), 2);
    if (cost >= best_cost) continue;
    best_cost = cost;
    best = t;
  }
  return best;
}

Eigen::Vector2d aimingAngles(const Vector3d& first, const Vector3d& second, const Vector3d& rest,
                             const Vector3d& wanted) {
  const double side = second.cross(rest).dot(first);  // 1 or -1
  return {angleAbout(first, rest, wanted),
          std::asin(std::clamp(side * wanted.dot(first), -1.0, 1.0))};
}

}  // namespace markerless_mocap
