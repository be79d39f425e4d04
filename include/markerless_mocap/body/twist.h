#pragma once

#include <Eigen/Geometry>

namespace markerless_mocap {

/// Twist of a revolute joint (Hsiao 2008, Eq. 3-17): unit axis w through a point q, v = -w x q.
struct Twist {
  Eigen::Vector3d v = Eigen::Vector3d::Zero();
  Eigen::Vector3d w = Eigen::Vector3d::Zero();

  static Twist revolute(const Eigen::Vector3d& axis, const Eigen::Vector3d& point) {
    return {-axis.cross(point), axis};
  }
};

/// Rigid motion exp(twist * angle). The rotation R is given by Rodrigues' formula, the translation
/// by (I - R)(w x v) (Hsiao 2008, Eq. 3-19, 3-20). \param angle radians
Eigen::Isometry3d exponential(const Twist& twist, double angle);

}  // namespace markerless_mocap
