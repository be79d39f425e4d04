#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>
#include <optional>

#include "body/urdf_spherical_joint.h"
#include "contour/model/contour_pose.h"
#include "markerless_mocap/body/body_model.h"

namespace markerless_mocap {

/// Converts between the pose of the contour body and the joint angles of the URDF body of the same
/// shape. The URDF has no spine twist: its clavicles point to the shoulders of the twisted trunk,
/// so that all joints but the roots of the clavicles keep their positions. If the URDF's ankles are
/// fixed, feet are at right angles.
class ContourUrdfConverter {
 public:
  /// Throws std::invalid_argument if the model lacks a joint, or if a joint's axes differ from
  /// those in urdf/human.urdf.in.
  explicit ContourUrdfConverter(std::shared_ptr<const BodyModel> model);

  /// If several sets of angles give the same pose, the one nearest to the last output is chosen.
  /// The angles are therefore continuous from call to call.
  /// \param angles radians, in the order of the model; they may slightly exceed the limits, which
  ///   are soft in the fit
  void convert(const ContourPose& pose, Eigen::Isometry3d& T_world_body, Eigen::VectorXd& angles);
  /// Forgets the last output.
  void reset();

  /// The pose of the contour body for a pose of the URDF body; spine twist and fixed ankles are 0.
  /// Throws std::invalid_argument if the number of angles is not that of the model.
  ContourPose poseOf(const Eigen::Isometry3d& T_world_body, const Eigen::VectorXd& angles) const;

 private:
  int angleOf(const std::string& joint, const Eigen::Vector3d& axis) const;
  void setSphericalJoint(size_t joint, const Eigen::Matrix3d& R, Eigen::VectorXd& angles) const;
  void setArm(int side, const ContourPose& pose, Eigen::VectorXd& angles) const;

  std::shared_ptr<const BodyModel> model_;
  /// Index of each angle; -1 if the URDF has none.
  std::array<int, RevoluteJoint::kCount> revolute_joints_;
  /// All but the root.
  std::array<std::optional<UrdfSphericalJoint>, SphericalJoint::kCount> spherical_joints_;
  Eigen::VectorXd last_;
};

}  // namespace markerless_mocap
