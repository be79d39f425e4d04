#include "capture/truth/body_retargeter.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "body/davenport_angles.h"
#include "capture/ground_truth.h"
#include "capture/truth/aiming_angles.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// Proportions of urdf/human.urdf.in: the fraction of the foot in front of the ankle, and the
// position of the head's frame.
constexpr double kFootBeforeAnkle = 0.76;

/// Below this sine of the hinge's angle the bone's own axis is used instead of the normal of the
/// plane of both bones.
constexpr double kNearlyStraight = 0.06;

const Vector3d& at(const PerBone<Vector3d>& joints, Bone bone) {
  return joints[size_t(bone)];
}

}  // namespace

/// A limb: a spherical joint and a hinge. The right is the mirror image of the left.
struct BodyRetargeter::Limb {
  std::array<std::string, 3> ball;
  std::string hinge;
  Bone upper, lower,
      end;       ///< their heads are the spherical joint, the hinge and the end of the limb
  double bends;  ///< 1: a positive angle bends the hinge forward; -1: backward
};

BodyProportions proportionsOf(const HumanSkeleton& s) {
  const Vector3d shoulder = s.headOf(Bone::kLeftUpperArm), ankle = s.headOf(Bone::kLeftFoot);
  const double hips = s.headOf(Bone::kHips).z(), neck = s.headOf(Bone::kNeck).z();
  BodyProportions p;
  p.torso = shoulder.z() - hips;
  p.neck = neck - shoulder.z();
  p.head = s.tailOf(Bone::kHead).z() - neck;
  p.upper_arm = s.lengthOf(Bone::kLeftUpperArm);
  p.forearm = s.lengthOf(Bone::kLeftForearm);
  p.hand = s.lengthOf(Bone::kLeftHand);
  p.thigh = s.lengthOf(Bone::kLeftThigh);
  p.shank = s.lengthOf(Bone::kLeftShank);
  p.foot = (s.tailOf(Bone::kLeftToes).x() - ankle.x()) / kFootBeforeAnkle;
  p.ankle_height = ankle.z();
  p.shoulder_width = 2.0 * shoulder.y();
  p.hip_width = 2.0 * s.headOf(Bone::kLeftThigh).y();
  p.girth = s.stature / 1.75;
  return p;
}

BodyRetargeter::BodyRetargeter(std::shared_ptr<const BodyModel> model, HumanSkeleton skeleton)
    : model_(std::move(model)),
      skeleton_(std::move(skeleton)),
      last_(Eigen::VectorXd::Zero(model_->angleCount())) {}

void BodyRetargeter::setAngle(const std::string& joint, double angle,
                              Eigen::VectorXd& angles) const {
  const BodyJoint& limits = model_->joint(joint);
  angles[limits.angle_index] = std::clamp(angle, limits.lower, limits.upper);
}

void BodyRetargeter::forward(const BodyState& state) {
  model_->forwardKinematics(state.T_world_body, state.angles, T_world_link_);
}

/// Sets two consecutive joints so that the direction `rest` of the second one's link points at a
/// point in the world.
void BodyRetargeter::aim(const std::string& first, const std::string& second, const Vector3d& rest,
                         const Vector3d& target, Eigen::VectorXd& angles) const {
  const BodyJoint &a = model_->joint(first), &b = model_->joint(second);
  const Vector3d away = target - T_world_link_[size_t(a.child_link)].translation();
  const Vector3d wanted = linkRotation(a.parent_link).transpose() * away.normalized();
  const Eigen::Vector2d t = aimingAngles(a.axis, b.axis, rest, wanted);
  setAngle(first, t[0], angles);
  setAngle(second, t[1], angles);
}

/// Sets three consecutive joints so that the last one's link has a given rotation.
void BodyRetargeter::turn(const std::array<std::string, 3>& joints, const Matrix3d& R_world,
                          Eigen::VectorXd& angles) const {
  std::array<Vector3d, 3> axes;
  Vector3d near;
  for (size_t i = 0; i < 3; ++i) {
    const BodyJoint& joint = model_->joint(joints[i]);
    axes[i] = joint.axis;
    near[Eigen::Index(i)] = last_[joint.angle_index];
  }
  const BodyJoint& middle = model_->joint(joints[1]);
  const Matrix3d R = linkRotation(model_->joint(joints[0]).parent_link).transpose() * R_world;
  const Vector3d t = davenportAngles(R, axes, near, middle.lower, middle.upper);
  for (size_t i = 0; i < 3; ++i) setAngle(joints[i], t[Eigen::Index(i)], angles);
}

void BodyRetargeter::setLimb(const Limb& limb, const HumanPose& pose,
                             const PerBone<Vector3d>& joints, Eigen::VectorXd& angles) const {
  const int ball_link = model_->joint(limb.ball[0]).child_link;
  const Vector3d ball = T_world_link_[size_t(ball_link)].translation();
  const Vector3d down = (at(joints, limb.lower) - ball).normalized();
  const Vector3d lower = (at(joints, limb.end) - at(joints, limb.lower)).normalized();
  const Vector3d aside = lower - down * down.dot(lower);
  const double slack = std::max(0.0, kNearlyStraight - aside.norm());
  const Vector3d front = limb.bends * aside + slack * (pose[limb.upper] * Vector3d::UnitX());
  const Vector3d x = (front - down * down.dot(front)).normalized();
  Matrix3d R_world;
  R_world << x, x.cross(down), -down;  // the z axis of a limb's link points to the trunk
  turn(limb.ball, R_world, angles);
  setAngle(limb.hinge, limb.bends * std::atan2(aside.norm(), down.dot(lower)), angles);
}

/// Sets the pitch of the foot to that of the person's; it cannot turn sideways.
void BodyRetargeter::setFoot(const std::string& ankle, const Vector3d& forward,
                             Eigen::VectorXd& angles) const {
  const BodyJoint& joint = model_->joint(ankle);
  const Vector3d along = linkRotation(joint.parent_link).transpose() * forward;
  setAngle(ankle, std::atan2(along.z(), along.x()), angles);
}

void BodyRetargeter::setHead(const HumanPose& pose, const PerBone<Vector3d>& joints,
                             Eigen::VectorXd& angles) const {
  const BodyJoint& head = model_->joint("head");
  const Vector3d middle =
      0.5 * (at(joints, Bone::kHead) + boneEnd(skeleton_, pose, joints, Bone::kHead));
  const auto frameOf = [](const Vector3d& up, const Vector3d& left) {
    const Vector3d u = up.normalized(), l = (left - u * u.dot(left)).normalized();
    Matrix3d frame;
    frame << u, l, u.cross(l);
    return frame;
  };
  const Vector3d neck = T_world_link_[size_t(head.parent_link)].translation();
  const Matrix3d now = frameOf(middle - neck, pose[Bone::kHead] * Vector3d::UnitY());
  const Matrix3d rest = frameOf(head.T_parent_joint.translation(), Vector3d::UnitY());
  turn({"r_head", "y_head", "p_head"}, now * rest.transpose(), angles);
}

BodyState BodyRetargeter::follow(const HumanPose& pose) {
  const PerBone<Vector3d> joints = jointPositions(skeleton_, pose);
  BodyState state;
  state.angles = Eigen::VectorXd::Zero(model_->angleCount());
  state.T_world_body.linear() = pose[Bone::kHips].toRotationMatrix();
  state.T_world_body.translation() = pose.hips;
  forward(state);
  aim("waist", "r_waist", Vector3d::UnitZ(), at(joints, Bone::kNeck), state.angles);
  forward(state);
  aim("l_y_clavicle", "l_r_clavicle", Vector3d::UnitY(), at(joints, Bone::kLeftUpperArm),
      state.angles);
  aim("r_y_clavicle", "r_r_clavicle", -Vector3d::UnitY(), at(joints, Bone::kRightUpperArm),
      state.angles);
  forward(state);
  const Limb limbs[] = {{{"l_y_shoulder", "l_p_shoulder", "l_r_shoulder"},
                         "l_elbow",
                         Bone::kLeftUpperArm,
                         Bone::kLeftForearm,
                         Bone::kLeftHand,
                         1.0},
                        {{"r_y_shoulder", "r_p_shoulder", "r_r_shoulder"},
                         "r_elbow",
                         Bone::kRightUpperArm,
                         Bone::kRightForearm,
                         Bone::kRightHand,
                         1.0},
                        {{"l_y_hip", "l_p_hip", "l_r_hip"},
                         "l_knee",
                         Bone::kLeftThigh,
                         Bone::kLeftShank,
                         Bone::kLeftFoot,
                         -1.0},
                        {{"r_y_hip", "r_p_hip", "r_r_hip"},
                         "r_knee",
                         Bone::kRightThigh,
                         Bone::kRightShank,
                         Bone::kRightFoot,
                         -1.0}};
  for (const Limb& limb : limbs) setLimb(limb, pose, joints, state.angles);
  setHead(pose, joints, state.angles);
  forward(state);
  setFoot("l_ankle", pose[Bone::kLeftFoot] * Vector3d::UnitX(), state.angles);
  setFoot("r_ankle", pose[Bone::kRightFoot] * Vector3d::UnitX(), state.angles);
  last_ = state.angles;
  return state;
}

}  // namespace markerless_mocap
