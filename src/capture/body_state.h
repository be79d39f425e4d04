#pragma once

#include <Eigen/Geometry>

namespace markerless_mocap {

/// State of a URDF body at one time.
struct BodyState {
  Eigen::Isometry3d T_world_body = Eigen::Isometry3d::Identity();
  Eigen::VectorXd angles;  ///< radians, in the order of BodyModel::angleNames()
};

}  // namespace markerless_mocap
