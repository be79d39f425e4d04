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

// urdf/human.urdf.in: clavicles begin at a tenth of the shoulder width, which puts the shoulder
// four times as far out again.
constexpr double kClavicleRoot = 0.1, kClavicle = 0.4;

}  // namespace

ContourUrdfConverter::ContourUrdfConverter(std::shared_ptr<const BodyModel> model)
    : model_(std::move(model)) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  single_.fill(-1);
  single_[A::kSpinePitch] = angleOf("waist", y);
  single_[A::kSpineRoll] = angleOf("r_waist", x);
  using Joints = std::array<std::string, 3>;
  balls_[B::kNeck].emplace(*model_, Joints{"r_head", "y_head", "p_head"});
  for (const int side : {0, 1}) {
    const std::string name = side ? "r_" : "l_";
    const double sign = side ? -1 : 1;
    const size_t yaw = side ? A::kRightClavicleYaw : A::kLeftClavicleYaw;
    single_[yaw] = angleOf(name + "y_clavicle", -sign * z);
    single_[yaw + 1] = angleOf(name + "r_clavicle", sign * x);
    single_[size_t(A::kLeftElbow + side)] = angleOf(name + "elbow", -y);
    single_[size_t(A::kLeftKnee + side)] = angleOf(name + "knee", -y);
    if (model_->joint(name + "ankle").angle_index >= 0)
      single_[size_t(A::kLeftAnkle + side)] = angleOf(name + "ankle", -y);
    balls_[size_t(B::kLeftShoulder + side)].emplace(
        *model_, Joints{name + "y_shoulder", name + "p_shoulder", name + "r_shoulder"});
    balls_[size_t(B::kLeftHip + side)].emplace(
        *model_, Joints{name + "y_hip", name + "p_hip", name + "r_hip"});
  }
  reset();
}

int ContourUrdfConverter::angleOf(const std::string& joint, const Vector3d& axis) const {
  if (!model_->joint(joint).axis.isApprox(axis, 1e-6))
    throw std::invalid_argument("body " + model_->id() + ": joint " + joint +
                                " does not turn about the axis that a contour body needs");
  return model_->angleIndex(joint);
}

void ContourUrdfConverter::reset() {
  last_ = Eigen::VectorXd::Zero(model_->angleCount());
}

void ContourUrdfConverter::setBall(size_t ball, const Matrix3d& R, Eigen::VectorXd& angles) const {
  balls_[ball]->set(R, last_, angles);
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
  angles[single_[yaw]] = turned;
  angles[single_[yaw + 1]] = lifted;
  const size_t ball = size_t(B::kLeftShoulder + side);
  setBall(ball, clavicle(turned, lifted).transpose() * wanted * pose.rotations[ball], angles);
}

void ContourUrdfConverter::convert(const ContourPose& pose, Eigen::Isometry3d& T_world_body,
                                   Eigen::VectorXd& angles) {
  T_world_body.linear() = pose.rotations[B::kRoot];
  T_world_body.translation() = pose.position;
  T_world_body.makeAffine();
  angles = Eigen::VectorXd::Zero(model_->angleCount());
  for (size_t a = 0; a < A::kCount; ++a)
    if (single_[a] >= 0) angles[single_[a]] = pose.angles[a];
  const Matrix3d twist = AngleAxisd(pose.angles[A::kSpineTwist], Vector3d::UnitZ()).matrix();
  setBall(B::kNeck, twist * pose.rotations[B::kNeck], angles);
  for (const int side : {0, 1}) {
    setArm(side, pose, angles);
    const size_t hip = size_t(B::kLeftHip + side);
    setBall(hip, pose.rotations[hip], angles);
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
    if (single_[a] >= 0) pose.angles[a] = angles[single_[a]];
  for (size_t b = B::kNeck; b < B::kCount; ++b) pose.rotations[b] = balls_[b]->rotation(angles);
  return pose;
}

}  // namespace markerless_mocap
