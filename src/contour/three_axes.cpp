#include "contour/three_axes.h"

#include <Eigen/Geometry>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kSingularSine = 1e-6;  // of the middle angle
constexpr double kOutsideCost = 1e3;    // rad^2, more than two solutions lie apart

double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  const Vector3d f = from - axis * axis.dot(from), t = to - axis * axis.dot(to);
  return std::atan2(axis.dot(f.cross(t)), f.dot(t));
}

}  // namespace

Vector3d threeAngles(const Matrix3d& R, const std::array<Vector3d, 3>& axes, const Vector3d& near,
                     double middle_lower, double middle_upper) {
  const double shift = std::atan2(axes[0].dot(axes[1].cross(axes[2])), axes[0].dot(axes[2]));
  const Vector3d reached = R * axes[2];
  const double opening = std::atan2(axes[0].cross(reached).norm(), axes[0].dot(reached));
  Vector3d best = near;
  double least = HUGE_VAL;
  for (const double sign : {1.0, -1.0}) {
    Vector3d t(near[0], shift + sign * opening, 0.0);
    const Matrix3d middle = AngleAxisd(t[1], axes[1]).toRotationMatrix();
    if (std::sin(opening) > kSingularSine) t[0] = angleAbout(axes[0], middle * axes[2], reached);
    const Matrix3d last = middle.transpose() * AngleAxisd(-t[0], axes[0]).toRotationMatrix() * R;
    t[2] = angleAbout(axes[2], axes[1], last * axes[1]);
    for (int i = 0; i < 3; ++i) t[i] += 2 * M_PI * std::round((near[i] - t[i]) / (2 * M_PI));
    const bool inside = t[1] >= middle_lower - 1e-9 && t[1] <= middle_upper + 1e-9;
    const double cost = (t - near).squaredNorm() + (inside ? 0.0 : kOutsideCost);
    if (cost < least) least = cost, best = t;
  }
  return best;
}

}  // namespace markerless_mocap
