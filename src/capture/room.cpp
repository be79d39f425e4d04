#include "capture/room.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "capture/hash.h"

namespace markerless_mocap {
namespace {

constexpr double kTileSide = 0.5;    // metres
constexpr double kGrainSide = 0.02;  // metres

/// -1 to 1, constant on small cubes of space.
double grain(const Eigen::Vector3d& point) {
  const Eigen::Vector3d cell = (point / kGrainSide).array().floor();
  const uint64_t key = uint64_t(int64_t(cell.x())) * 73856093u ^
                       uint64_t(int64_t(cell.y())) * 19349663u ^
                       uint64_t(int64_t(cell.z())) * 83492791u;
  return 2.0 * hashUniform(key) - 1.0;
}

Eigen::Vector3d floorColor(const Eigen::Vector3d& point) {
  const int64_t tile =
      int64_t(std::floor(point.x() / kTileSide)) + int64_t(std::floor(point.y() / kTileSide));
  const double shade = tile % 2 == 0 ? 0.03 : -0.03;
  return Eigen::Vector3d(0.50, 0.52, 0.50).array() + shade;
}

Eigen::Vector3d wallColor(const Eigen::Vector3d& point, int axis, double height) {
  const Eigen::Vector3d low(0.50, 0.62, 0.56), high(0.66, 0.76, 0.70);
  const double up = std::clamp(point.z() / height, 0.0, 1.0);
  const double panel = 0.03 * std::sin(4.0 * point[1 - axis]);
  return (low + up * (high - low)).array() + panel + (axis == 0 ? 0.02 : -0.02);
}

}  // namespace

Eigen::Vector3d roomAround(const Eigen::Vector3d& eye) {
  const double half = eye.head<2>().norm() + 1.5;
  return {std::max(half, 5.0), std::max(half, 5.0), std::max(eye.z() + 0.5, 4.5)};
}

Eigen::Vector3d roomColor(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction,
                          const Eigen::Vector3d& half_size) {
  double nearest = std::numeric_limits<double>::infinity();
  int face = 2;
  for (int axis = 0; axis < 3; ++axis) {
    if (direction[axis] == 0.0) continue;
    const double low = axis == 2 ? 0.0 : -half_size[axis];
    const double wall = direction[axis] > 0.0 ? half_size[axis] : low;
    const double distance = (wall - eye[axis]) / direction[axis];
    if (distance < nearest) {
      nearest = distance;
      face = axis;
    }
  }
  const Eigen::Vector3d point = eye + nearest * direction;
  Eigen::Vector3d color(0.80, 0.80, 0.78);
  if (face < 2)
    color = wallColor(point, face, half_size.z());
  else if (direction.z() < 0.0)
    color = floorColor(point);
  return color.array() + 0.02 * grain(point);
}

}  // namespace markerless_mocap
