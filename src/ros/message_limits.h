#pragma once

#include <Eigen/Core>

namespace markerless_mocap {

/// Places farther from the origin of the world are no places in a room, metres. What comes in by
/// a message is refused beyond them.
constexpr double kFarthestPlace = 1e4;

/// Whether a point is finite and within kFarthestPlace on each axis.
inline bool isPlace(const Eigen::Vector3d& point) {
  return (point.array().abs() < kFarthestPlace).all();  // false for NaN
}

}  // namespace markerless_mocap
