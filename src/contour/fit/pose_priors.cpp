#include "contour/fit/pose_priors.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace markerless_mocap {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using A = RevoluteJoint;
using B = SphericalJoint;

constexpr double kLimitDeviation = 0.05;  // rad beyond a limit

/// An angle's limits and what it is usually: 0, with a deviation; 0: anything is usual. Radians.
struct AngleRule {
  double lower, upper, deviation;
};
// Limits as in urdf/human.urdf.in where the URDF has the joint.
constexpr AngleRule kAngleRules[A::kCount] = {
    {-0.6, 1.4, 0.15}, {-0.7, 0.7, 0.15}, {-0.8, 0.8, 0.10},                     // spine
    {-0.4, 0.5, 0.09}, {-0.3, 0.7, 0.09}, {-0.4, 0.5, 0.09}, {-0.3, 0.7, 0.09},  // clavicles
    {0.0, 2.7, 0.0},   {0.0, 2.7, 0.0},                                          // elbows
    {-2.7, 0.0, 0.0},  {-2.7, 0.0, 0.0},                                         // knees
    {-0.9, 0.6, 0.3},  {-0.9, 0.6, 0.3}};                                        // ankles

/// A ball's twist about its limb, counted from the pose in which the limb points along `rest`: that
/// is far from the direction in which twists are not defined, -rest, where no limb gets to.
struct TwistRule {
  int ball;
  Vector3d rest;  ///< of the limb's z in the parent's frame; the limb points along -z
  double limit, deviation;
};
const TwistRule kTwistRules[] = {{B::kNeck, {0, 0, 1}, 1.4, 0.5},
                                 {B::kLeftShoulder, {-0.6, -0.6, 0.5}, 1.7, 0.8},
                                 {B::kRightShoulder, {-0.6, 0.6, 0.5}, 1.7, 0.8},
                                 {B::kLeftHip, {-0.5, 0, 0.9}, 0.9, 0.3},
                                 {B::kRightHip, {-0.5, 0, 0.9}, 0.9, 0.3}};

/// The limb's z must not point further along a direction of the parent than this.
struct DirectionRule {
  int ball;
  Vector3d along;
  double most;
};
const DirectionRule kDirectionRules[] = {
    {B::kNeck, {0, 0, -1}, -0.4},          // the head hangs at most so far
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

// An arm that no contour holds hangs: its upper arm's z in the frame of the left clavicle, and the
// elbow's bend. Away from there by more than the deviation (radians) the pull is the same however
// far, and any contour outweighs it.
const Vector3d kHanging = Vector3d(0.05, -0.13, 1.0).normalized();
constexpr double kHangingDeviation = 0.1;
constexpr double kBend = 0.2, kBendDeviation = 0.15;

/// A residual of the three degrees of freedom of a ball.
struct BallResidual {
  double value;
  Vector3d slope;
};

BallResidual twistOf(const TwistRule& rule, const Matrix3d& R) {
  const auto reference = Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), rule.rest);
  Eigen::Quaterniond q = reference.conjugate() * Eigen::Quaterniond(R);
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  // Swing and twist: the twist about z is 2 atan2(z, w); q exp(step) changes w and z by these.
  const Vector3d dw = -0.5 * q.vec();
  const Vector3d dz = 0.5 * Vector3d(-q.y(), q.x(), q.w());
  const double size = std::max(1e-9, q.z() * q.z() + q.w() * q.w());
  return {2.0 * std::atan2(q.z(), q.w()), 2.0 * (q.w() * dz - q.z() * dw) / size};
}

BallResidual directionOf(const DirectionRule& rule, const Matrix3d& R) {
  // R exp(step) z = R z + R (step x z)
  const Vector3d along = R.transpose() * rule.along;
  return {along.z(), Vector3d::UnitZ().cross(along)};
}

/// What is beyond -limit or limit.
double excess(double value, double lower, double upper) {
  return value - std::clamp(value, lower, upper);
}

double inverseSquare(double deviation) {
  return 1.0 / (deviation * deviation);
}

/// 1 + half the square of a residual over its deviation where that is small, and linear beyond
/// (pseudo-Huber): the error, and what the residual's weight is divided by.
double softened(double residual, double deviation) {
  return std::hypot(1.0, residual / deviation);
}

/// How an arm differs from a hanging one: its direction (1 is a radian) and its bend, radians.
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

/// Calls add(first dof, slope, residual, weight) for every residual that is at work.
template <typename Add>
void forEachResidual(const ContourPose& pose, const Add& add) {
  const double hard = inverseSquare(kLimitDeviation);
  const Eigen::Matrix<double, 1, 1> one = Eigen::Matrix<double, 1, 1>::Ones();
  for (int a = 0; a < A::kCount; ++a) {
    const AngleRule& rule = kAngleRules[a];
    const double angle = pose.angles[size_t(a)], over = excess(angle, rule.lower, rule.upper);
    if (over != 0) add(revoluteDof(a), one, over, hard);
    if (rule.deviation > 0) add(revoluteDof(a), one, angle, inverseSquare(rule.deviation));
  }
  for (const TwistRule& rule : kTwistRules) {
    const BallResidual twist = twistOf(rule, pose.rotations[size_t(rule.ball)]);
    const double over = excess(twist.value, -rule.limit, rule.limit);
    add(sphericalDof(rule.ball), twist.slope, twist.value, inverseSquare(rule.deviation));
    if (over != 0) add(sphericalDof(rule.ball), twist.slope, over, hard);
  }
  for (const DirectionRule& rule : kDirectionRules) {
    const BallResidual direction = directionOf(rule, pose.rotations[size_t(rule.ball)]);
    const double over = direction.value - rule.most;
    if (over > 0) add(sphericalDof(rule.ball), direction.slope, over, hard);
  }
}

/// Inverse of the right Jacobian of rotations: how the vector of log(R) changes with R exp(step).
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
  forEachResidual(pose, [&](int dof, const auto& slope, double residual, double weight) {
    equations.add(dof, slope, residual, weight);
  });
}

void addArmRestPrior(const ContourPose& pose, PoseNormalEquations& equations) {
  const Eigen::Matrix<double, 1, 1> one = Eigen::Matrix<double, 1, 1>::Ones();
  for (const size_t side : {0, 1}) {
    const ArmAtRest arm = armAtRest(pose, side);
    const int shoulder = B::kLeftShoulder + int(side), elbow = A::kLeftElbow + int(side);
    const double weight =
        inverseSquare(kHangingDeviation) / softened(arm.away.norm(), kHangingDeviation);
    for (int i = 0; i < 3; ++i) {
      const DirectionRule along{shoulder, Vector3d::Unit(i), 0};
      equations.add(sphericalDof(shoulder),
                    directionOf(along, pose.rotations[size_t(shoulder)]).slope, arm.away[i],
                    weight);
    }
    equations.add(revoluteDof(elbow), one, arm.bend,
                  inverseSquare(kBendDeviation) / softened(arm.bend, kBendDeviation));
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
        Eigen::Quaterniond::FromTwoVectors(Vector3d::UnitZ(), hangingOf(side)).toRotationMatrix();
    pose.angles[A::kLeftElbow + side] = kBend;
  }
  return pose;
}

double armRestEnergy(const ContourPose& pose) {
  double energy = 0.0;
  for (const size_t side : {0, 1}) {
    const ArmAtRest arm = armAtRest(pose, side);
    energy += softened(arm.away.norm(), kHangingDeviation) - 1.0;
    energy += softened(arm.bend, kBendDeviation) - 1.0;
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

double motionPriorEnergy(const ContourPose& pose, const ContourPose& expected,
                         double turn_deviation, double move_deviation) {
  const PoseIncrement away = boxMinus(pose, expected);
  return 0.5 * inverseSquare(move_deviation) * away.head<3>().squaredNorm() +
         0.5 * inverseSquare(turn_deviation) * away.tail<kContourDof - 3>().squaredNorm();
}

double maxLimitViolation(const ContourPose& pose) {
  double worst = 0.0;
  for (size_t a = 0; a < A::kCount; ++a)
    worst = std::max(worst,
                     std::abs(excess(pose.angles[a], kAngleRules[a].lower, kAngleRules[a].upper)));
  for (const TwistRule& rule : kTwistRules)
    worst = std::max(worst, std::abs(excess(twistOf(rule, pose.rotations[size_t(rule.ball)]).value,
                                            -rule.limit, rule.limit)));
  for (const DirectionRule& rule : kDirectionRules)
    worst = std::max(worst, directionOf(rule, pose.rotations[size_t(rule.ball)]).value - rule.most);
  return worst;
}

}  // namespace markerless_mocap
