#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "body/urdf_spherical_joint.h"
#include "fleischmann/fleischmann_body_model.h"

namespace markerless_mocap {

/// Converts Fleischmann's parameters to the root pose and angles of the URDF body, and back. The
/// result is continuous from call to call.
class FleischmannUrdfConverter {
 public:
  /// Throws std::invalid_argument if the model lacks a required joint, or if a joint has another
  /// axis.
  explicit FleischmannUrdfConverter(std::shared_ptr<const BodyModel> model);

  /// \param angles radians, in the order of the model; the ankles, which have no parameters, are 0
  void convert(const FleischmannVector& v, Eigen::Isometry3d& T_world_body,
               Eigen::VectorXd& angles);
  /// The parameters of a pose of the model, nearest to those of the last call of either function.
  FleischmannVector parametersOf(const Eigen::Isometry3d& T_world_body,
                                 const Eigen::VectorXd& angles);

 private:
  struct SphericalJoint {
    FleischmannSegment parent, child;
    UrdfSphericalJoint joint;
  };
  struct Hinge {
    int parameter, angle;
    double sign;
  };
  void addHinge(const std::string& joint, int parameter, const Eigen::Vector3d& axis);

  std::shared_ptr<const BodyModel> model_;
  FleischmannBodyModel body_model_;
  std::vector<SphericalJoint> spherical_joints_;
  std::vector<Hinge> hinges_;
  Eigen::VectorXd last_angles_;
  FleischmannVector last_ = FleischmannVector::Zero();
};

}  // namespace markerless_mocap
