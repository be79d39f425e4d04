#pragma once

#include <Eigen/Geometry>
#include <array>
#include <memory>

#include "markerless_mocap/fitting/hsiao_profile.h"

namespace markerless_mocap {

/// Angles t with R = exp(axes[0] t0) exp(axes[1] t1) exp(axes[2] t2); neighbouring axes must be
/// perpendicular unit vectors. Of the two solutions (and their full turns) the one nearest to
/// `near` is taken whose middle angle is inside its limits, if there is one; where only a sum of
/// the outer angles is defined, the first keeps its value.
Eigen::Vector3d decomposeRotation(const Eigen::Matrix3d& R,
                                  const std::array<Eigen::Vector3d, 3>& axes,
                                  const Eigen::Vector3d& near, double middle_lower,
                                  double middle_upper);

/// Turns H's parameters into the URDF's root pose and angles, continuously from call to call.
class HsiaoConversion {
 public:
  /// Throws std::invalid_argument if a three-axis joint of the model is not a chain of
  /// perpendicular axes, or an elbow or knee does not turn about y.
  HsiaoConversion(std::shared_ptr<const BodyModel> model,
                  std::shared_ptr<const HsiaoProfile> profile);

  /// \param v H's parameters
  /// \param angles radians in the model's order; joints outside the profile are 0
  void convert(const HsiaoVector& v, Eigen::Isometry3d& T_world_body, Eigen::VectorXd& angles);
  /// Forgets the last output.
  void reset();

 private:
  struct Ball {
    int parent, child;  ///< segments
    std::array<Eigen::Vector3d, 3> axes;
    std::array<int, 3> angle;
    double lower, upper;  ///< of the middle angle
  };
  struct Hinge {
    int parent, child;
    int angle;
    double sign;
  };
  void addBall(const std::array<const char*, 3>& joints, const std::string& side, int parent,
               int child);
  void addHinge(const std::string& joint, int parent, int child);

  std::shared_ptr<const BodyModel> model_;
  std::shared_ptr<const HsiaoProfile> profile_;
  std::vector<Ball> balls_;
  std::vector<Hinge> hinges_;
  Eigen::VectorXd last_;
};

}  // namespace markerless_mocap
