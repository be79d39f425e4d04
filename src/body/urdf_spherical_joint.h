#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// A spherical joint: three joints of the URDF about perpendicular axes at one point.
class UrdfSphericalJoint {
 public:
  /// \param joints base names, in any order; throws std::invalid_argument if they are not a chain
  ///   with perpendicular axes
  UrdfSphericalJoint(const BodyModel& model, const std::array<std::string, 3>& joints);
  /// Sets the angles that give the child the rotation R relative to the parent, nearest to those of
  /// `last`, radians.
  void set(const Eigen::Matrix3d& R, const Eigen::VectorXd& last, Eigen::VectorXd& angles) const;
  /// Rotation of the child relative to the parent.
  Eigen::Matrix3d rotation(const Eigen::VectorXd& angles) const;

 private:
  std::array<Eigen::Vector3d, 3> axes_;
  std::array<int, 3> angle_;
  double lower_, upper_;  // of the middle angle, radians
};

}  // namespace markerless_mocap
