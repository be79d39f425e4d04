#include "body/davenport_angles.h"

#include <Eigen/Geometry>
#include <cmath>

#include "body/rotations.h"

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this sine of the middle angle only the sum of the outer angles is defined.
constexpr double kSingularSine = 1e-6;

// More than the squared distance of any two solutions, rad^2.
constexpr double kOutsideCost = 1e3;

Vector3d solveOuter(const Matrix3d& R, const std::array<Vector3d, 3>& axes, double middle,
                    double sine, double held_first) {
  const Matrix3d M = AngleAxisd(middle, axes[1]).toRotationMatrix();
  Vector3d t(held_first, middle, 0.0);
  if (std::abs(sine) > kSingularSine) t[0] = angleAbout(axes[0], M * axes[2], R * axes[2]);
  const Matrix3d last = M.transpose() * AngleAxisd(-t[0], axes[0]).toRotationMatrix() * R;
  t[2] = angleAbout(axes[2], axes[1], last * axes[1]);
  return t;
}

}  // namespace

Vector3d davenportAngles(const Matrix3d& R, const std::array<Vector3d, 3>& axes,
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

}  // namespace markerless_mocap
