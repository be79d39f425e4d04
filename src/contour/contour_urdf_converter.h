#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>

#include "body/urdf_spherical_joint.h"
#include "contour/model/contour_pose.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Between the contour body's pose and the angles of the URDF body of the same sizes. The URDF has
/// no twist of the spine: its clavicles point at where the twisted shoulders are, so all joints but
/// the clavicles' roots keep their places. If its ankles are fixed, feet stay at right angles.
class ContourUrdfConverter {
 public:
  /// Throws std::invalid_argument if the model lacks a joint or turns it about other axes than
  /// urdf/human.urdf.in does.
  explicit ContourUrdfConverter(std::shared_ptr<const BodyModel> model);

  /// Of several sets of angles that give the same pose the one nearest to the last one given out is
  /// taken, so they are continuous from call to call.
  /// \param angles radians in the model's order; soft limits of the fit may be left by a little
  void convert(const ContourPose& pose, Eigen::Isometry3d& T_world_body, Eigen::VectorXd& angles);
  /// Forgets the last output.
  void reset();

  /// The contour body's pose that the URDF body stands in; the spine's twist and fixed ankles
  /// are 0. Throws std::invalid_argument unless there are as many angles as the model has.
  ContourPose poseOf(const Eigen::Isometry3d& T_world_body, const Eigen::VectorXd& angles) const;

 private:
  int angleOf(const std::string& joint, const Eigen::Vector3d& axis) const;
  void setBall(size_t ball, const Eigen::Matrix3d& R, Eigen::VectorXd& angles) const;
  void setArm(int side, const ContourPose& pose, Eigen::VectorXd& angles) const;

  std::shared_ptr<const BodyModel> model_;
  std::array<int, RevoluteJoint::kCount>
      single_;  ///< position of each angle; -1 if the URDF has none
  std::array<std::optional<UrdfSphericalJoint>, SphericalJoint::kCount>
      balls_;  ///< all but the root's
  Eigen::VectorXd last_;
};

}  // namespace markerless_mocap
