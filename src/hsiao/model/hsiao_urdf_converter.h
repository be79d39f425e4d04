#pragma once

#include <Eigen/Geometry>
#include <memory>
#include <vector>

#include "body/urdf_spherical_joint.h"
#include "hsiao/model/hsiao_body_model.h"

namespace markerless_mocap {

/// Converts Hsiao's parameters to the root pose and angles of the URDF body. The result is
/// continuous from call to call.
class HsiaoUrdfConverter {
 public:
  /// Throws std::invalid_argument if the axes of a three-axis joint of the model are not
  /// perpendicular, or if an elbow or knee does not turn about y.
  HsiaoUrdfConverter(std::shared_ptr<const BodyModel> model,
                     std::shared_ptr<const HsiaoBodyModel> body_model);

  /// \param v Hsiao's parameters
  /// \param angles radians, in the order of the model; joints without parameters are 0
  void convert(const HsiaoVector& v, Eigen::Isometry3d& T_world_body, Eigen::VectorXd& angles);
  /// Forgets the last output.
  void reset();

 private:
  struct SphericalJoint {
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
  std::shared_ptr<const HsiaoBodyModel> body_model_;
  std::vector<SphericalJoint> spherical_joints_;
  std::vector<Hinge> hinges_;
  Eigen::VectorXd last_;
};

}  // namespace markerless_mocap
