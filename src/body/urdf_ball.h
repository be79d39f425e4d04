#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>

#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Angles t with R = exp(axes[0] t0) exp(axes[1] t1) exp(axes[2] t2); neighbouring axes must be
/// perpendicular unit vectors. Of the two solutions (and their full turns) the one nearest to
/// `near` is taken whose middle angle is inside its limits, if there is one; where only a sum of
/// the outer angles is defined, the first keeps its value.
Eigen::Vector3d decomposeRotation(const Eigen::Matrix3d& R,
                                  const std::array<Eigen::Vector3d, 3>& axes,
                                  const Eigen::Vector3d& near, double middle_lower,
                                  double middle_upper);

/// Three joints of the URDF about perpendicular axes in one place: a ball joint.
class UrdfBall {
 public:
  /// \param joints base names, in any order; throws std::invalid_argument if they are no chain of
  ///   perpendicular axes
  UrdfBall(const BodyModel& model, const std::array<std::string, 3>& joints);
  /// Writes the angles that turn the child by R against the parent, nearest to those of `last`.
  void set(const Eigen::Matrix3d& R, const Eigen::VectorXd& last, Eigen::VectorXd& angles) const;

 private:
  std::array<Eigen::Vector3d, 3> axes_;
  std::array<int, 3> angle_;
  double lower_, upper_;  // of the middle angle
};

}  // namespace markerless_mocap
