#include "hsiao/model/hsiao_urdf_converter.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;

}  // namespace

HsiaoUrdfConverter::HsiaoUrdfConverter(std::shared_ptr<const BodyModel> model,
                                       std::shared_ptr<const HsiaoBodyModel> body_model)
    : model_(std::move(model)), body_model_(std::move(body_model)) {
  spherical_joints_.push_back(
      {kTorsoSegment, kHeadSegment, UrdfSphericalJoint(*model_, {"r_head", "y_head", "p_head"})});
  const std::array<std::string, 2> sides = {"l_", "r_"};
  for (int side = 0; side < 2; ++side) {
    const std::string& s = sides[side];
    spherical_joints_.push_back(
        {kTorsoSegment, kUpperArmSegment + side,
         UrdfSphericalJoint(*model_, {s + "y_shoulder", s + "p_shoulder", s + "r_shoulder"})});
    spherical_joints_.push_back(
        {kTorsoSegment, kThighSegment + side,
         UrdfSphericalJoint(*model_, {s + "y_hip", s + "p_hip", s + "r_hip"})});
    addHinge(sides[side] + "elbow", kUpperArmSegment + side, kForearmSegment + side);
    addHinge(sides[side] + "knee", kThighSegment + side, kShankSegment + side);
  }
  reset();
}

void HsiaoUrdfConverter::addHinge(const std::string& joint_name, int parent, int child) {
  const BodyJoint& joint = model_->joint(joint_name);
  if (joint.angle_index < 0 || std::abs(std::abs(joint.axis.y()) - 1.0) > 1e-9)
    throw std::invalid_argument("body " + model_->id() + ": joint " + joint.name +
                                " must turn about y or -y");
  hinges_.push_back({parent, child, joint.angle_index, joint.axis.y()});
}

void HsiaoUrdfConverter::reset() {
  last_ = Eigen::VectorXd::Zero(model_->angleCount());
}

void HsiaoUrdfConverter::convert(const HsiaoVector& v, Eigen::Isometry3d& T_world_body,
                                 Eigen::VectorXd& angles) {
  HsiaoFrames frames;
  body_model_->frames(v.data(), frames);
  T_world_body.linear() = frames.R[kTorsoSegment];
  T_world_body.translation() =
      frames.p[kTorsoSegment] + frames.R[kTorsoSegment] * body_model_->root();
  angles = Eigen::VectorXd::Zero(model_->angleCount());
  for (const SphericalJoint& joint : spherical_joints_)
    joint.joint.set(frames.R[joint.parent].transpose() * frames.R[joint.child], last_, angles);
  for (const Hinge& hinge : hinges_) {
    const Matrix3d R = frames.R[hinge.parent].transpose() * frames.R[hinge.child];
    angles[hinge.angle] = hinge.sign * std::atan2(R(0, 2), R(2, 2));
  }
  last_ = angles;
}

}  // namespace markerless_mocap
