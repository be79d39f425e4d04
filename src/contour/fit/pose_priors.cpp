#include "contour/fit/pose_priors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "contour/model/angle_ranges.h"
#include "numerics/shortest_rotation.h"

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using A = RevoluteJoint;
using B = SphericalJoint;

constexpr double kLimitDeviation = 0.05;  // rad beyond a limit

/// Standard deviations of the angles about 0, radians; 0: any angle is as likely.
constexpr std::array<double, A::kCount> kAngleDeviations = {0.15, 0.15, 0.10,        // spine
                                                            0.09, 0.09, 0.09, 0.09,  // clavicles
                                                            0.0,  0.0,               // elbows
                                                            0.0,  0.0,               // knees
                                                            0.3,  0.3};              // ankles

/// Twist of a spherical joint about its limb, relative to the pose in which the limb points along
/// `rest`. `rest` is chosen so that the singularity of the twist, -rest, is a direction that no
/// limb reaches.
struct TwistPrior {
  int joint;
  Vector3d rest;  ///< of the limb's z axis in the parent's frame; the limb points along -z
  double limit, deviation;
};
const TwistPrior kTwistPriors[] = {{B::kNeck, {0, 0, 1}, 1.4, 0.5},
                                   {B::kLeftShoulder, {-0.6, -0.6, 0.5}, 1.7, 0.8},
                                   {B::kRightShoulder, {-0.6, 0.6, 0.5}, 1.7, 0.8},
                                   {B::kLeftHip, {-0.5, 0, 0.9}, 0.9, 0.3},
                                   {B::kRightHip, {-0.5, 0, 0.9}, 0.9, 0.3}};

/// Maximum component of the limb's z axis along a direction in the parent's frame.
struct DirectionLimit {
  int joint;
  Vector3d along;
  double maximum;
};
const DirectionLimit kDirectionLimits[] = {
    {B::kNeck, {0, 0, -1}, -0.4},          // limit of the head's forward bend
    {B::kLeftShoulder, {0, 1, 0}, 0.8},    // across the chest
    {B::kRightShoulder, {0, -1, 0}, 0.8},  //
    {B::kLeftShoulder, {1, 0, 0}, 0.85},   // backwards
    {B::kRightShoulder, {1, 0, 0}, 0.85},  //
    {B::kLeftHip, {0, 1, 0}, 0.5},         // across the other leg
    {B::kRightHip, {0, -1, 0}, 0.5},       //
    {B::kLeftHip, {1, 0, 0}, 0.65},        // backwards
    {B::kRightHip, {1, 0, 0}, 0.65},       //
    {B::kLeftHip, {0, 0, -1}, 0.75},       // to the chest
    {B::kRightHip, {0, 0, -1}, 0.75}};

// An arm without evidence hangs: direction of the upper arm's z axis in the frame of the left
// clavicle, and angle of the elbow. Beyond the deviation (radians) the pull is constant, and any
// contour outweighs it.
const Vector3d kHanging = Vector3d(0.05, -0.13, 1.0).normalized();
constexpr double kHangingDeviation = 0.1;
constexpr double kBend = 0.2, kBendDeviation = 0.15;

/// Residual of a spherical joint and its gradient with respect to the three degrees of freedom.
struct SphericalResidual {
  double value;
  Vector3d gradient;
};

SphericalResidual twistOf(const TwistPrior& rule, const Matrix3d& R) {
  const auto reference = shortestRotation(Vector3d::UnitZ(), rule.rest);
  Eigen::Quaterniond q = reference.conjugate() * Eigen::Quaterniond(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  // Swing-twist decomposition: the twist about z is 2 atan2(z, w). dw and dz are the derivatives of
  // w and z for q exp(step).
  const Vector3d dw = -0.5 * q.vec();
  const Vector3d dz = 0.5 * Vector3d(-q.y(), q.x(), q.w());
  const double size = std::max(1e-9, q.z() * q.z() + q.w() * q.w());
  return {2.0 * std::atan2(q.z(), q.w()), 2.0 * (q.w() * dz - q.z() * dw) / size};
}

SphericalResidual directionOf(const DirectionLimit& rule, const Matrix3d& R) {
  // R exp(step) z = R z + R (step x z)
  const Vector3d along = R.transpose() * rule.along;
  return {along.z(), Vector3d::UnitZ().cross(along)};
}

/// Distance beyond the limits, with sign.
double excess(double value, const AngleRange& range) {
  return value - std::clamp(value, range.lower, range.upper);
}

double inverseSquare(double deviation) {
  return 1.0 / (deviation * deviation);
}

/// Pseudo-Huber loss plus 1: 1 + half the squared ratio of residual to deviation if it is small,
/// linear beyond. It is also the divisor of the residual's weight.
double pseudoHuber(double residual, double deviation) {
  return std::hypot(1.0, residual / deviation);
}

/// Difference of an arm from the hanging one: direction (unit vectors) and elbow angle, radians.
struct ArmAtRest {
  Vector3d away;
  double bend;
};
Vector3d hangingOf(size_t side) {
  return {kHanging.x(), side ? -kHanging.y() : kHanging.y(), kHanging.z()};
}
ArmAtRest armAtRest(const ContourPose& pose, size_t side) {
  return {pose.rotations[B::kLeftShoulder + side].col(2) - hangingOf(side),
          pose.angles[A::kLeftElbow + side] - kBend};
}

/// Calls add(first dof, gradient, residual, weight) for every active residual.
template <typename Add>
void forEachResidual(const ContourPose& pose, const Add& add) {
  const double hard = inverseSquare(kLimitDeviation);
  const Eigen::Matrix<double, 1, 1> one = Eigen::Matrix<double, 1, 1>::Ones();
  for (size_t a = 0; a < A::kCount; ++a) {
    const int dof = revoluteDof(int(a));
    const double angle = pose.angles[a], over = excess(angle, kAngleRanges[a]);
    if (over != 0) add(dof, one, over, hard);
    if (kAngleDeviations[a] > 0) add(dof, one, angle, inverseSquare(kAngleDeviations[a]));
  }
  for (const TwistPrior& rule : kTwistPriors) {
    const SphericalResidual twist = twistOf(rule, pose.rotations[size_t(rule.joint)]);
    const double over = excess(twist.value, {-rule.limit, rule.limit});
    add(sphericalDof(rule.joint), twist.gradient, twist.value, inverseSquare(rule.deviation));
    if (over != 0) add(sphericalDof(rule.joint), twist.gradient, over, hard);
  }
  for (const DirectionLimit& rule : kDirectionLimits) {
    const SphericalResidual direction = directionOf(rule, pose.rotations[size_t(rule.joint)]);
    const double over = direction.value - rule.maximum;
    if (over > 0) add(sphericalDof(rule.joint), direction.gradient, over, hard);
  }
}

/// Inverse of the right Jacobian of SO(3): the derivative of log(R exp(step)) with respect to step.
Matrix3d inverseRightJacobian(const Vector3d& turn) {
  const double angle2 = turn.squaredNorm(), angle = std::sqrt(angle2);
  Matrix3d cross;
  cross << 0, -turn.z(), turn.y(), turn.z(), 0, -turn.x(), -turn.y(), turn.x(), 0;
  const double second =
      angle < 1e-3 ? 1.0 / 12 : 1 / angle2 - (1 + std::cos(angle)) / (2 * angle * std::sin(angle));
  return Matrix3d::Identity() + 0.5 * cross + second * cross * cross;
}

}  // namespace

void addPosturePriors(const ContourPose& pose, PoseNormalEquations& equations) {
  forEachResidual(pose, [&](int dof, const auto& gradient, double residual, double weight) {
    equations.add(dof, gradient, residual, weight);
  });
}

void addArmRestPrior(const ContourPose& pose, PoseNormalEquations& equations) {
  const Eigen::Matrix<double, 1, 1> one = Eigen::Matrix<double, 1, 1>::Ones();
  for (const size_t side : {0, 1}) {
    const ArmAtRest arm = armAtRest(pose, side);
    const int shoulder = B::kLeftShoulder + int(side), elbow = A::kLeftElbow + int(side);
    const double weight =
        inverseSquare(kHangingDeviation) / pseudoHuber(arm.away.norm(), kHangingDeviation);
    for (int i = 0; i < 3; ++i) {
      const DirectionLimit along{shoulder, Vector3d::Unit(i), 0};
      equations.add(sphericalDof(shoulder),
                    directionOf(along, pose.rotations[size_t(shoulder)]).gradient, arm.away[i],
                    weight);
    }
    equations.add(revoluteDof(elbow), one, arm.bend,
                  inverseSquare(kBendDeviation) / pseudoHuber(arm.bend, kBendDeviation));
  }
}

double postureEnergy(const ContourPose& pose) {
  double energy = 0.0;
  forEachResidual(pose, [&](int, const auto&, double residual, double weight) {
    energy += 0.5 * weight * residual * residual;
  });
  return energy;
}

ContourPose withArmsAtRest(ContourPose pose) {
  for (const size_t side : {0, 1}) {
    pose.rotations[B::kLeftShoulder + side] =
        shortestRotation(Vector3d::UnitZ(), hangingOf(side)).toRotationMatrix();
    pose.angles[A::kLeftElbow + side] = kBend;
  }
  return pose;
}

double armRestEnergy(const ContourPose& pose) {
  double energy = 0.0;
  for (const size_t side : {0, 1}) {
    const ArmAtRest arm = armAtRest(pose, side);
    energy += pseudoHuber(arm.away.norm(), kHangingDeviation) - 1.0;
    energy += pseudoHuber(arm.bend, kBendDeviation) - 1.0;
  }
  return energy;
}

void addMotionPrior(const ContourPose& pose, const ContourPose& expected, double turn_deviation,
                    double move_deviation, PoseNormalEquations& equations) {
  const PoseIncrement away = boxMinus(pose, expected);
  const double move = inverseSquare(move_deviation), turn = inverseSquare(turn_deviation);
  equations.H.diagonal().head<3>().array() += move;
  equations.g.head<3>() += move * away.head<3>();
  for (int b = 0; b < B::kCount; ++b) {
    const Vector3d off = away.segment<3>(sphericalDof(b));
    const Matrix3d J = inverseRightJacobian(off);
    equations.H.block<3, 3>(sphericalDof(b), sphericalDof(b)) += turn * J.transpose() * J;
    equations.g.segment<3>(sphericalDof(b)) += turn * J.transpose() * off;
  }
  equations.H.diagonal().tail<A::kCount>().array() += turn;
  equations.g.tail<A::kCount>() += turn * away.tail<A::kCount>();
}

double maxLimitViolation(const ContourPose& pose) {
  double worst = 0.0;
  for (size_t a = 0; a < A::kCount; ++a)
    worst = std::max(worst, std::abs(excess(pose.angles[a], kAngleRanges[a])));
  for (const TwistPrior& rule : kTwistPriors)
    worst = std::max(worst, std::abs(excess(twistOf(rule, pose.rotations[size_t(rule.joint)]).value,
                                            {-rule.limit, rule.limit})));
  for (const DirectionLimit& rule : kDirectionLimits)
    worst =
        std::max(worst, directionOf(rule, pose.rotations[size_t(rule.joint)]).value - rule.maximum);
  return worst;
}

}  // namespace markerless_mocap
