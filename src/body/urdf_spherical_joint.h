#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Three joints of the URDF about perpendicular axes in one place: a ball joint.
class UrdfSphericalJoint {
 public:
  /// \param joints base names, in any order; throws std::invalid_argument if they are no chain of
  ///   perpendicular axes
  UrdfSphericalJoint(const BodyModel& model, const std::array<std::string, 3>& joints);
  /// Writes the angles that turn the child by R against the parent, nearest to those of `last`.
  void set(const Eigen::Matrix3d& R, const Eigen::VectorXd& last, Eigen::VectorXd& angles) const;
  /// Of the child against the parent.
  Eigen::Matrix3d rotation(const Eigen::VectorXd& angles) const;

 private:
  std::array<Eigen::Vector3d, 3> axes_;
  std::array<int, 3> angle_;
  double lower_, upper_;  // of the middle angle
};

}  // namespace markerless_mocap
