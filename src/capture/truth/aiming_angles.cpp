#include "capture/truth/aiming_angles.h"

#include <algorithm>
#include <cmath>

#include "body/rotations.h"

namespace markerless_mocap {

using Eigen::Vector3d;

Eigen::Vector2d aimingAngles(const Vector3d& first, const Vector3d& second, const Vector3d& rest,
                             const Vector3d& wanted) {
  const double side = second.cross(rest).dot(first);  // 1 or -1
  return {angleAbout(first, rest, wanted),
          std::asin(std::clamp(side * wanted.dot(first), -1.0, 1.0))};
}

}  // namespace markerless_mocap
