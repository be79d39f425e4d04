#include "hsiao/model/hsiao_body_model.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>

#include "body/rotations.h"
#include "body/zero_pose.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

const std::array<std::string, 2> kSides = {"l_", "r_"};

// Hsiao's zero pose is a T-pose, while the model's arms hang: a rotation by 90 degrees about x
// (left +, right -).
Matrix3d hangingToSideways(int side) {
  const double s = side == 0 ? 1.0 : -1.0;
  return (Matrix3d() << 1, 0, 0, 0, 0, -s, 0, s, 0).finished();
}

// The point of the link's geometry that is farthest along `direction`, in the link's frame.
Vector3d extremePoint(const BodyModel& model, const std::string& link_name,
                      const Vector3d& direction) {
  const int link = model.linkIndex(link_name);
  double reach = -HUGE_VAL;
  Vector3d extreme = Vector3d::Zero();
  const auto consider = [&](const Vector3d& end, double radius) {
    const Vector3d point = end + radius * direction;
    if (direction.dot(point) <= reach) return;
    reach = direction.dot(point);
    extreme = point;
  };
  for (const RoundCone& cone : model.shape()) {
    if (cone.link != link) continue;
    consider(cone.a, cone.radius_a);
    consider(cone.b, cone.radius_b);
  }
  if (reach == -HUGE_VAL)
    throw std::invalid_argument("body " + model.id() + ": link " + link_name +
                                " has no geometry, at least one sphere or cylinder is needed");
  return extreme;
}

}  // namespace

HsiaoBodyModel::HsiaoBodyModel(const BodyModel& model) {
  const LinkPoses zero = uprightZeroPose(model);
  const auto at = [&](const std::string& name) -> Vector3d {
    return zero[model.linkIndex(name)].translation();
  };
  const Vector3d hips = 0.5 * (at("l_hip") + at("r_hip"));
  const Vector3d neck = at("r_head");
  const Vector3d center = 0.5 * (hips + neck);
  half_torso_ = (neck - center).norm();
  axis_ = (neck - center) / half_torso_;
  root_ = -center;
  joint_[kTorsoSegment].setZero();
  joint_[kHeadSegment] = neck - center;
  bones_[size_t(PartLabel::kTorso)] = {{kTorsoSegment, hips - center},
                                       {kTorsoSegment, neck - center}};
  bones_[size_t(PartLabel::kHead)] = {
      {kTorsoSegment, neck - center},
      {kHeadSegment, at("head") - neck + extremePoint(model, "head", Vector3d::UnitZ())}};
  for (int side = 0; side < 2; ++side) addLimb(model, zero, side);
  assignLinks(model, zero);
}

void HsiaoBodyModel::addLimb(const BodyModel& model, const LinkPoses& zero, int side) {
  const auto at = [&](const std::string& name) -> Vector3d {
    return zero[model.linkIndex(kSides[side] + name)].translation();
  };
  const auto add = [&](PartLabel part, int upper, int lower, const std::string& first,
                       const std::string& middle, const std::string& last,
                       const Vector3d& tip_direction) {
    joint_[upper + side] = at(first) + root_;
    joint_[lower + side] = at(middle) - at(first);
    const Vector3d end = at(last) - at(middle);
    bones_[size_t(part) + side] = {
        {kTorsoSegment, joint_[upper + side]},
        {upper + side, joint_[lower + side]},
        {lower + side, end},
        {lower + side, end + extremePoint(model, kSides[side] + last, tip_direction)}};
  };
  add(PartLabel::kArm1, kUpperArmSegment, kForearmSegment, "shoulder", "elbow", "wrist",
      -Vector3d::UnitZ());
  add(PartLabel::kLeg1, kThighSegment, kShankSegment, "hip", "knee", "ankle", Vector3d::UnitX());
}

void HsiaoBodyModel::assignLinks(const BodyModel& model, const LinkPoses& zero) {
  std::vector<int> start(model.links().size(), -1);
  start[model.linkIndex("r_head")] = kHeadSegment;
  for (int side = 0; side < 2; ++side) {
    start[model.linkIndex(kSides[side] + "shoulder")] = kUpperArmSegment + side;
    start[model.linkIndex(kSides[side] + "elbow")] = kForearmSegment + side;
    start[model.linkIndex(kSides[side] + "hip")] = kThighSegment + side;
    start[model.linkIndex(kSides[side] + "knee")] = kShankSegment + side;
  }
  std::vector<Vector3d> origin(kHsiaoSegments, -root_);
  links_.assign(start.size(), {kTorsoSegment, Vector3d::Zero()});
  for (const BodyJoint& joint : model.joints())
    links_[joint.child_link].segment =
        start[joint.child_link] >= 0 ? start[joint.child_link] : links_[joint.parent_link].segment;
  for (size_t i = 0; i < start.size(); ++i)
    if (start[i] >= 0) origin[start[i]] = zero[i].translation();
  for (size_t i = 0; i < start.size(); ++i)
    links_[i].offset = zero[i].translation() - origin[links_[i].segment];
}

void HsiaoBodyModel::frames(const double* v, HsiaoFrames& out) const {
  const Eigen::Map<const Vector3d> center(v + kHsiaoCenter), neck(v + kHsiaoNeck);
  const auto theta = [v](int k) { return v[hsiaoTheta(k)]; };
  Vector3d up = neck - center;
  const double length = up.norm();
  up = length > 1e-9 ? Vector3d(up / length) : axis_;
  const Matrix3d torso =
      shortestRotation(axis_, up) * Eigen::AngleAxisd(v[kHsiaoSpin], axis_).toRotationMatrix();
  const auto place = [&](int segment, int parent, const Matrix3d& R) {
    out.R[segment].noalias() = out.R[parent] * R;
    out.p[segment] = out.p[parent] + out.R[parent] * joint_[segment];
  };
  out.R[kTorsoSegment] = torso;
  out.p[kTorsoSegment] = center;
  place(kHeadSegment, kTorsoSegment, rotX(theta(1)) * rotY(theta(2)));
  for (int side = 0; side < 2; ++side) {
    // The elbow turns about Hsiao's z axis, which is y (left) or -y (right) of the hanging arm.
    const double elbow = side == 0 ? theta(9) : -theta(10);
    place(kUpperArmSegment + side, kTorsoSegment,
          rotX(theta(3 + side)) * rotY(theta(5 + side)) * rotZ(theta(7 + side)) *
              hangingToSideways(side));
    place(kForearmSegment + side, kUpperArmSegment + side, rotY(elbow));
    place(kThighSegment + side, kTorsoSegment, rotX(theta(11 + side)) * rotY(theta(13 + side)));
    place(kShankSegment + side, kThighSegment + side, rotY(theta(15 + side)));
  }
}

}  // namespace markerless_mocap
