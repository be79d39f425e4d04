#include "capture/truth/aiming_angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::Vector3d;

double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  return std::atan2(axis.dot(from.cross(to)), from.dot(to) - axis.dot(from) * axis.dot(to));
}

}  // namespace

Eigen::Vector2d aimingAngles(const Vector3d& first, const Vector3d& second, const Vector3d& rest,
                             const Vector3d& wanted) {
  const double side = second.cross(rest).dot(first);  // 1 or -1
  return {angleAbout(first, rest, wanted),
          std::asin(std::clamp(side * wanted.dot(first), -1.0, 1.0))};
}

}  // namespace markerless_mocap
