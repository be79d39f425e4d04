#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "body/urdf_spherical_joint.h"
#include "fleischmann/fleischmann_body_model.h"

namespace markerless_mocap {

/// Turns F's parameters into the URDF's root pose and angles, continuously from call to call, and
/// back.
class FleischmannUrdfConverter {
 public:
  /// Throws std::invalid_argument if the model lacks a joint of the profile or has it about another
  /// axis.
  explicit FleischmannUrdfConverter(std::shared_ptr<const BodyModel> model);

  /// \param angles radians in the model's order; ankles, which F's body lacks, at 0
  void convert(const FleischmannVector& v, Eigen::Isometry3d& T_world_body,
               Eigen::VectorXd& angles);
  /// The parameters of a pose of the model, nearest to those of the last call of either.
  FleischmannVector parametersOf(const Eigen::Isometry3d& T_world_body,
                                 const Eigen::VectorXd& angles);

 private:
  struct Ball {
    FleischmannSegment parent, child;
    UrdfSphericalJoint joint;
  };
  struct Hinge {
    int parameter, angle;
    double sign;
  };
  void addHinge(const std::string& joint, int parameter, const Eigen::Vector3d& axis);

  std::shared_ptr<const BodyModel> model_;
  FleischmannBodyModel profile_;
  std::vector<Ball> balls_;
  std::vector<Hinge> hinges_;
  Eigen::VectorXd last_angles_;
  FleischmannVector last_ = FleischmannVector::Zero();
};

}  // namespace markerless_mocap
