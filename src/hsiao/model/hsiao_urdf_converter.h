#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "body/urdf_spherical_joint.h"
#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// Turns H's parameters into the URDF's root pose and angles, continuously from call to call.
class HsiaoUrdfConverter {
 public:
  /// Throws std::invalid_argument if a three-axis joint of the model is not a chain of
  /// perpendicular axes, or an elbow or knee does not turn about y.
  HsiaoUrdfConverter(std::shared_ptr<const BodyModel> model,
                     std::shared_ptr<const HsiaoBodyModel> profile);

  /// \param v H's parameters
  /// \param angles radians in the model's order; joints outside the profile are 0
  void convert(const HsiaoVector& v, Eigen::Isometry3d& T_world_body, Eigen::VectorXd& angles);
  /// Forgets the last output.
  void reset();

 private:
  struct Ball {
    int parent, child;  ///< segments
    UrdfSphericalJoint joint;
  };
  struct Hinge {
    int parent, child;
    int angle;
    double sign;
  };
  void addHinge(const std::string& joint, int parent, int child);

  std::shared_ptr<const BodyModel> model_;
  std::shared_ptr<const HsiaoBodyModel> profile_;
  std::vector<Ball> balls_;
  std::vector<Hinge> hinges_;
  Eigen::VectorXd last_;
};

}  // namespace markerless_mocap
