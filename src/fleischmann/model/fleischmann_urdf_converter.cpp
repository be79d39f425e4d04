#include "fleischmann/model/fleischmann_urdf_converter.h"

#include <cmath>
#include <stdexcept>

namespace markerless_mocap {

using Eigen::Vector3d;

FleischmannUrdfConverter::FleischmannUrdfConverter(std::shared_ptr<const BodyModel> model)
    : model_(std::move(model)), body_model_(*model_) {
  spherical_joints_.push_back(
      {kChestSegment, kSkullSegment, UrdfSphericalJoint(*model_, {"r_head", "y_head", "p_head"})});
  addHinge("waist", kSpine, Vector3d::UnitY());
  addHinge("r_waist", kSpine + 1, Vector3d::UnitX());
  const auto addSide = [&](const std::string& s, double sign, int side, int clavicle, int elbow,
                           int knee) {
    spherical_joints_.push_back(
        {FleischmannSegment(kLeftClavicleSegment + side), FleischmannSegment(kLeftUpperArm + side),
         UrdfSphericalJoint(*model_, {s + "y_shoulder", s + "p_shoulder", s + "r_shoulder"})});
    spherical_joints_.push_back(
        {kPelvisSegment, FleischmannSegment(kLeftThigh + side),
         UrdfSphericalJoint(*model_, {s + "y_hip", s + "p_hip", s + "r_hip"})});
    addHinge(s + "y_clavicle", clavicle, -sign * Vector3d::UnitZ());
    addHinge(s + "r_clavicle", clavicle + 1, sign * Vector3d::UnitX());
    addHinge(s + "elbow", elbow, -Vector3d::UnitY());
    addHinge(s + "knee", knee, Vector3d::UnitY());
  };
  addSide("l_", 1.0, 0, kLeftClavicle, kLeftElbow, kLeftKnee);
  addSide("r_", -1.0, 1, kRightClavicle, kRightElbow, kRightKnee);
  last_angles_ = Eigen::VectorXd::Zero(model_->angleCount());
}

void FleischmannUrdfConverter::addHinge(const std::string& name, int parameter,
                                        const Vector3d& axis) {
  const BodyJoint& joint = model_->joint(name);
  const double along = joint.axis.dot(axis);
  if (joint.angle_index < 0 || std::abs(std::abs(along) - 1.0) > 1e-9)
    throw std::invalid_argument("body " + model_->id() + ": joint " + joint.name +
                                " must turn about the axis of its parameter");
  hinges_.push_back({parameter, joint.angle_index, along});
}

void FleischmannUrdfConverter::convert(const FleischmannVector& v, Eigen::Isometry3d& T_world_body,
                                       Eigen::VectorXd& angles) {
  FleischmannFrames frames;
  body_model_.frames(v.data(), frames);
  T_world_body.linear() = frames.R[kPelvisSegment];
  T_world_body.translation() = frames.p[kPelvisSegment];
  angles = Eigen::VectorXd::Zero(model_->angleCount());
  for (const SphericalJoint& joint : spherical_joints_)
    joint.joint.set(frames.R[joint.parent].transpose() * frames.R[joint.child], last_angles_,
                    angles);
  for (const Hinge& hinge : hinges_) angles[hinge.angle] = hinge.sign * v[hinge.parameter];
  last_angles_ = angles;
  last_ = v;
}

FleischmannVector FleischmannUrdfConverter::parametersOf(const Eigen::Isometry3d& T_world_body,
                                                         const Eigen::VectorXd& angles) {
  LinkPoses links;
  model_->forwardKinematics(T_world_body, angles, links);
  last_ = body_model_.parametersOf(links, last_);
  last_angles_ = angles;
  return last_;
}

}  // namespace markerless_mocap
