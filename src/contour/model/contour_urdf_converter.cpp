#include "contour/contour_urdf_converter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using A = RevoluteJoint;
using B = SphericalJoint;

// urdf/human.urdf.in: a clavicle begins at a tenth of the shoulder width and is four times as long.
constexpr double kClavicleRoot = 0.1, kClavicle = 0.4;

}  // namespace

ContourUrdfConverter::ContourUrdfConverter(std::shared_ptr<const BodyModel> model)
    : model_(std::move(model)) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  revolute_joints_.fill(-1);
  revolute_joints_[A::kSpinePitch] = angleOf("waist", y);
  revolute_joints_[A::kSpineRoll] = angleOf("r_waist", x);
  using Joints = std::array<std::string, 3>;
  spherical_joints_[B::kNeck].emplace(*model_, Joints{"r_head", "y_head", "p_head"});
  for (const int side : {0, 1}) {
    const std::string name = side ? "r_" : "l_";
    const double sign = side ? -1 : 1;
    const size_t yaw = side ? A::kRightClavicleYaw : A::kLeftClavicleYaw;
    revolute_joints_[yaw] = angleOf(name + "y_clavicle", -sign * z);
    revolute_joints_[yaw + 1] = angleOf(name + "r_clavicle", sign * x);
    revolute_joints_[size_t(A::kLeftElbow + side)] = angleOf(name + "elbow", -y);
    revolute_joints_[size_t(A::kLeftKnee + side)] = angleOf(name + "knee", -y);
    if (model_->joint(name + "ankle").angle_index >= 0)
      revolute_joints_[size_t(A::kLeftAnkle + side)] = angleOf(name + "ankle", -y);
    spherical_joints_[size_t(B::kLeftShoulder + side)].emplace(
        *model_, Joints{name + "y_shoulder", name + "p_shoulder", name + "r_shoulder"});
    spherical_joints_[size_t(B::kLeftHip + side)].emplace(
        *model_, Joints{name + "y_hip", name + "p_hip", name + "r_hip"});
  }
  reset();
}

int ContourUrdfConverter::angleOf(const std::string& joint, const Vector3d& axis) const {
  if (!model_->joint(joint).axis.isApprox(axis, 1e-6))
    throw std::invalid_argument("body " + model_->id() + ": joint " + joint +
                                " does not turn about the axis that the contour body requires");
  return model_->angleIndex(joint);
}

void ContourUrdfConverter::reset() {
  last_ = Eigen::VectorXd::Zero(model_->angleCount());
}

void ContourUrdfConverter::setSphericalJoint(size_t joint, const Matrix3d& R,
                                             Eigen::VectorXd& angles) const {
  spherical_joints_[joint]->set(R, last_, angles);
}

void ContourUrdfConverter::setArm(int side, const ContourPose& pose,
                                  Eigen::VectorXd& angles) const {
  const double sign = side ? -1 : 1;
  const size_t yaw = side ? A::kRightClavicleYaw : A::kLeftClavicleYaw;
  const Matrix3d twist = AngleAxisd(pose.angles[A::kSpineTwist], Vector3d::UnitZ()).matrix();
  const auto clavicle = [&](double yaw_angle, double roll_angle) {
    return Matrix3d(AngleAxisd(yaw_angle, -sign * Vector3d::UnitZ()) *
                    AngleAxisd(roll_angle, sign * Vector3d::UnitX()));
  };
  const Matrix3d wanted = twist * clavicle(pose.angles[yaw], pose.angles[yaw + 1]);
  const Vector3d out = sign * Vector3d::UnitY();
  const Vector3d shoulder = kClavicleRoot * (twist * out) + kClavicle * (wanted * out);
  const Vector3d way = (shoulder - kClavicleRoot * out).normalized();
  const double turned = std::atan2(way.x(), sign * way.y());
  const double lifted = std::asin(std::clamp(way.z(), -1.0, 1.0));
  angles[revolute_joints_[yaw]] = turned;
  angles[revolute_joints_[yaw + 1]] = lifted;
  const size_t joint = size_t(B::kLeftShoulder + side);
  setSphericalJoint(joint, clavicle(turned, lifted).transpose() * wanted * pose.rotations[joint],
                    angles);
}

void ContourUrdfConverter::convert(const ContourPose& pose, Eigen::Isometry3d& T_world_body,
                                   Eigen::VectorXd& angles) {
  T_world_body.linear() = pose.rotations[B::kRoot];
  T_world_body.translation() = pose.position;
  T_world_body.makeAffine();
  angles = Eigen::VectorXd::Zero(model_->angleCount());
  for (size_t a = 0; a < A::kCount; ++a)
    if (revolute_joints_[a] >= 0) angles[revolute_joints_[a]] = pose.angles[a];
  const Matrix3d twist = AngleAxisd(pose.angles[A::kSpineTwist], Vector3d::UnitZ()).matrix();
  setSphericalJoint(B::kNeck, twist * pose.rotations[B::kNeck], angles);
  for (const int side : {0, 1}) {
    setArm(side, pose, angles);
    const size_t hip = size_t(B::kLeftHip + side);
    setSphericalJoint(hip, pose.rotations[hip], angles);
  }
  last_ = angles;
}

ContourPose ContourUrdfConverter::poseOf(const Eigen::Isometry3d& T_world_body,
                                         const Eigen::VectorXd& angles) const {
  if (angles.size() != model_->angleCount())
    throw std::invalid_argument("body " + model_->id() + " has " +
                                std::to_string(model_->angleCount()) + " joint angles, " +
                                std::to_string(angles.size()) + " were given");
  ContourPose pose;
  pose.position = T_world_body.translation();
  pose.rotations[B::kRoot] = T_world_body.linear();
  for (size_t a = 0; a < A::kCount; ++a)
    if (revolute_joints_[a] >= 0) pose.angles[a] = angles[revolute_joints_[a]];
  for (size_t b = B::kNeck; b < B::kCount; ++b)
    pose.rotations[b] = spherical_joints_[b]->rotation(angles);
  return pose;
}

}  // namespace markerless_mocap
