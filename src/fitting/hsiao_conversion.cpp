#include "markerless_mocap/fitting/hsiao_conversion.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace markerless_mocap {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;

// Below this sine of the middle angle the outer angles are told apart by the last output alone.
constexpr double kSingularSine = 1e-6;

// More than any two solutions lie apart (rad^2).
constexpr double kOutsideCost = 1e3;

// Angle that turns `from` to `to` about `axis`.
double angleAbout(const Vector3d& axis, const Vector3d& from, const Vector3d& to) {
  const Vector3d f = from - axis * axis.dot(from), t = to - axis * axis.dot(to);
  return std::atan2(axis.dot(f.cross(t)), f.dot(t));
}

double nearestTurn(double angle, double near) {
  return angle + 2 * M_PI * std::round((near - angle) / (2 * M_PI));
}

Vector3d solveOuter(const Matrix3d& R, const std::array<Vector3d, 3>& axes, double middle,
                    double sine, double held_first) {
  const Matrix3d M = AngleAxisd(middle, axes[1]).toRotationMatrix();
  Vector3d t(held_first, middle, 0.0);
  if (std::abs(sine) > kSingularSine) t[0] = angleAbout(axes[0], M * axes[2], R * axes[2]);
  const Matrix3d last = M.transpose() * AngleAxisd(-t[0], axes[0]).toRotationMatrix() * R;
  t[2] = angleAbout(axes[2], axes[1], last * axes[1]);
  return t;
}

// A model turned many times over must not wind up its angles without bound.
double unwind(double angle) {
  return std::abs(angle) < 2 * M_PI ? angle : std::remainder(angle, 2 * M_PI);
}

}  // namespace

Vector3d decomposeRotation(const Matrix3d& R, const std::array<Vector3d, 3>& axes,
                           const Vector3d& near, double middle_lower, double middle_upper) {
  const double shift = std::atan2(axes[0].dot(axes[1].cross(axes[2])), axes[0].dot(axes[2]));
  const Vector3d reached = R * axes[2];
  const double opening = std::atan2(axes[0].cross(reached).norm(), axes[0].dot(reached));
  Vector3d best = Vector3d::Zero();
  double best_distance = HUGE_VAL;
  for (const double sign : {1.0, -1.0}) {
    Vector3d t = solveOuter(R, axes, shift + sign * opening, std::sin(opening), near[0]);
    for (int i = 0; i < 3; ++i) t[i] = nearestTurn(t[i], near[i]);
    const bool inside = t[1] >= middle_lower - 1e-9 && t[1] <= middle_upper + 1e-9;
    const double distance = (t - near).squaredNorm() + (inside ? 0.0 : kOutsideCost);
    if (distance < best_distance) {
      best_distance = distance;
      best = t;
    }
  }
  return best;
}

HsiaoConversion::HsiaoConversion(std::shared_ptr<const BodyModel> model,
                                 std::shared_ptr<const HsiaoProfile> profile)
    : model_(std::move(model)), profile_(std::move(profile)) {
  addBall({"r_head", "y_head", "p_head"}, "", kTorsoSegment, kHeadSegment);
  const std::array<std::string, 2> sides = {"l_", "r_"};
  for (int side = 0; side < 2; ++side) {
    addBall({"y_shoulder", "p_shoulder", "r_shoulder"}, sides[side], kTorsoSegment,
            kUpperArmSegment + side);
    addBall({"y_hip", "p_hip", "r_hip"}, sides[side], kTorsoSegment, kThighSegment + side);
    addHinge(sides[side] + "elbow", kUpperArmSegment + side, kForearmSegment + side);
    addHinge(sides[side] + "knee", kThighSegment + side, kShankSegment + side);
  }
  reset();
}

void HsiaoConversion::addBall(const std::array<const char*, 3>& joints, const std::string& side,
                              int parent, int child) {
  std::array<const BodyJoint*, 3> chain;
  for (int i = 0; i < 3; ++i) chain[i] = &model_->joint(side + joints[i]);
  std::sort(chain.begin(), chain.end(), [](const BodyJoint* a, const BodyJoint* b) {
    return a->child_link < b->child_link;  // parents come first
  });
  Ball ball{parent, child, {}, {}, chain[1]->lower, chain[1]->upper};
  for (int i = 0; i < 3; ++i) {
    const bool linked = i == 0 || (chain[i]->parent_link == chain[i - 1]->child_link &&
                                   std::abs(chain[i]->axis.dot(chain[i - 1]->axis)) < 1e-9);
    if (!linked || chain[i]->angle_index < 0)
      throw std::invalid_argument("body " + model_->id() + ": joint " + chain[i]->name +
                                  " must turn about an axis perpendicular to its parent joint's");
    ball.axes[i] = chain[i]->axis;
    ball.angle[i] = chain[i]->angle_index;
  }
  balls_.push_back(ball);
}

void HsiaoConversion::addHinge(const std::string& joint_name, int parent, int child) {
  const BodyJoint& joint = model_->joint(joint_name);
  if (joint.angle_index < 0 || std::abs(std::abs(joint.axis.y()) - 1.0) > 1e-9)
    throw std::invalid_argument("body " + model_->id() + ": joint " + joint.name +
                                " must turn about y or -y");
  hinges_.push_back({parent, child, joint.angle_index, joint.axis.y()});
}

void HsiaoConversion::reset() {
  last_ = Eigen::VectorXd::Zero(model_->angleCount());
}

void HsiaoConversion::convert(const HsiaoVector& v, Eigen::Isometry3d& T_world_body,
                              Eigen::VectorXd& angles) {
  HsiaoFrames frames;
  profile_->frames(v.data(), frames);
  T_world_body.linear() = frames.R[kTorsoSegment];
  T_world_body.translation() = frames.p[kTorsoSegment] + frames.R[kTorsoSegment] * profile_->root();
  angles = Eigen::VectorXd::Zero(model_->angleCount());
  for (const Ball& ball : balls_) {
    const Matrix3d R = frames.R[ball.parent].transpose() * frames.R[ball.child];
    const Vector3d near(last_[ball.angle[0]], last_[ball.angle[1]], last_[ball.angle[2]]);
    const Vector3d t =
        decomposeRotation(R, ball.axes, near.unaryExpr(&unwind), ball.lower, ball.upper);
    for (int i = 0; i < 3; ++i) angles[ball.angle[i]] = t[i];
  }
  for (const Hinge& hinge : hinges_) {
    const Matrix3d R = frames.R[hinge.parent].transpose() * frames.R[hinge.child];
    angles[hinge.angle] = hinge.sign * std::atan2(R(0, 2), R(2, 2));
  }
  last_ = angles;
}

}  // namespace markerless_mocap
