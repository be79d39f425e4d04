#include "arm_chain.h"

#include <urdf_parser/urdf_parser.h>

#include <algorithm>
#include <stdexcept>

namespace {

constexpr int kIterations = 20;
constexpr double kDamping = 0.02;  // where directions do not tell an angle, it stays
constexpr double kStep = 1e-5;     // rad, of differences

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  Eigen::Quaterniond rotation;
  pose.rotation.getQuaternion(rotation.x(), rotation.y(), rotation.z(), rotation.w());
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * rotation;
}

/// From the root to the link.
std::vector<urdf::JointSharedPtr> jointsTo(const urdf::ModelInterface& robot, std::string link) {
  if (!robot.getLink(link)) throw std::invalid_argument("the robot has no link " + link);
  std::vector<urdf::JointSharedPtr> joints;
  while (const urdf::JointSharedPtr joint = robot.getLink(link)->parent_joint) {
    joints.push_back(joint);
    link = joint->parent_link_name;
  }
  std::reverse(joints.begin(), joints.end());
  return joints;
}

}  // namespace

ArmChain::ArmChain(const std::string& urdf, const std::string& shoulder, const std::string& elbow,
                   const std::string& tip) {
  const urdf::ModelInterfaceSharedPtr robot = urdf::parseURDF(urdf);
  if (!robot) throw std::invalid_argument("robot_description is no URDF");
  Eigen::Isometry3d T_joint_link = Eigen::Isometry3d::Identity();
  shoulder_ = elbow_ = tip_ = {-2, T_joint_link};
  for (const urdf::JointSharedPtr& joint : jointsTo(*robot, tip)) {
    T_joint_link = T_joint_link * isometry(joint->parent_to_joint_origin_transform);
    if (joint->type != urdf::Joint::FIXED) {
      if (joint->type != urdf::Joint::REVOLUTE || !joint->limits)
        throw std::invalid_argument(joint->name + " is no revolute joint with limits");
      joints_.push_back({joint->name,
                         T_joint_link,
                         {joint->axis.x, joint->axis.y, joint->axis.z},
                         joint->limits->lower,
                         joint->limits->upper,
                         joint->limits->velocity});
      T_joint_link.setIdentity();
    }
    const Link link{int(joints_.size()) - 1, T_joint_link};
    if (joint->child_link_name == shoulder) shoulder_ = link;
    if (joint->child_link_name == elbow) elbow_ = link;
    tip_ = link;
  }
  if (shoulder_.joint == -2 || elbow_.joint == -2)
    throw std::invalid_argument(shoulder + " and " + elbow + " must lie before " + tip);
}

Eigen::VectorXd ArmChain::clamped(const Eigen::VectorXd& angles) const {
  Eigen::VectorXd inside = angles;
  for (size_t i = 0; i < joints_.size(); ++i)
    inside[long(i)] = std::clamp(angles[long(i)], joints_[i].lower, joints_[i].upper);
  return inside;
}

Eigen::Vector3d ArmChain::place(const Link& link, const Eigen::VectorXd& angles) const {
  Eigen::Isometry3d T_root_joint = Eigen::Isometry3d::Identity();
  for (int i = 0; i <= link.joint; ++i)
    T_root_joint = T_root_joint * joints_[size_t(i)].T_parent_joint *
                   Eigen::AngleAxisd(angles[i], joints_[size_t(i)].axis);
  return (T_root_joint * link.T_joint_link).translation();
}

Eigen::Matrix<double, 6, 1> ArmChain::directions(const Eigen::VectorXd& angles) const {
  const Eigen::Vector3d elbow = place(elbow_, angles);
  Eigen::Matrix<double, 6, 1> directions;
  directions << (elbow - place(shoulder_, angles)).normalized(),
      (place(tip_, angles) - elbow).normalized();
  return directions;
}

// Damped least squares: where the arm is stretched or hangs, some angles are not determined.
Eigen::VectorXd ArmChain::follow(const Eigen::Matrix<double, 6, 1>& wanted,
                                 Eigen::VectorXd angles) const {
  const long count = angles.size();
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    const Eigen::Matrix<double, 6, 1> now = directions(angles);
    Eigen::MatrixXd jacobian(6, count);
    for (long i = 0; i < count; ++i)
      jacobian.col(i) =
          (directions(angles + kStep * Eigen::VectorXd::Unit(count, i)) - now) / kStep;
    const Eigen::MatrixXd damped =
        jacobian.transpose() * jacobian + kDamping * Eigen::MatrixXd::Identity(count, count);
    angles = clamped(angles + damped.ldlt().solve(jacobian.transpose() * (wanted - now)));
  }
  return angles;
}
