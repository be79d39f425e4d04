#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

/// The joints of a robot's arm from the root of its URDF to its tip.
class ArmChain {
 public:
  struct Joint {
    std::string name;
    Eigen::Isometry3d T_parent_joint;
    Eigen::Vector3d axis;
    double lower, upper;  ///< rad
    double velocity;      ///< rad/s
  };

  /// \param shoulder, elbow, tip names of links, in this order along the arm
  /// Throws std::invalid_argument if the URDF has no such arm or a joint of it has no limits.
  ArmChain(const std::string& urdf, const std::string& shoulder, const std::string& elbow,
           const std::string& tip);

  const std::vector<Joint>& joints() const { return joints_; }
  Eigen::VectorXd clamped(const Eigen::VectorXd& angles) const;
  /// Unit vectors shoulder to elbow and elbow to tip, in the root's frame, one below the other.
  Eigen::Matrix<double, 6, 1> directions(const Eigen::VectorXd& angles) const;
  /// Angles within the limits whose directions are nearest to the wanted ones, searched from
  /// `start`.
  Eigen::VectorXd follow(const Eigen::Matrix<double, 6, 1>& wanted, Eigen::VectorXd start) const;

 private:
  struct Link {
    int joint;  ///< the last moving joint before it, -1 for none
    Eigen::Isometry3d T_joint_link;
  };
  Eigen::Vector3d place(const Link& link, const Eigen::VectorXd& angles) const;

  std::vector<Joint> joints_;
  Link shoulder_, elbow_, tip_;
};
