#pragma once

#include <Eigen/Geometry>

namespace markerless_mocap {

/// Animation programs: y up, a person who faces the world's x faces z.
inline Eigen::Matrix3d animationFromWorld() {
  return (Eigen::Matrix3d() << 0, 1, 0, 0, 0, 1, 1, 0, 0).finished();
}

/// OpenSim: y up, z to the right of a person who faces x.
inline Eigen::Matrix3d opensimFromWorld() {
  return (Eigen::Matrix3d() << 1, 0, 0, 0, 0, 1, 0, -1, 0).finished();
}

/// A rotation in other axes.
inline Eigen::Quaterniond turned(const Eigen::Matrix3d& axes, const Eigen::Quaterniond& rotation) {
  return Eigen::Quaterniond(Eigen::Matrix3d(axes * rotation.toRotationMatrix() * axes.transpose()));
}

}  // namespace markerless_mocap
